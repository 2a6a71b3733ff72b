// The messages of other people's programs: ROS 1 connects only where name and MD5 sum agree.
#include <gazebo_msgs/ApplyBodyWrench.h>
#include <gazebo_msgs/BodyRequest.h>
#include <gazebo_msgs/DeleteModel.h>
#include <gazebo_msgs/GetJointProperties.h>
#include <gazebo_msgs/GetLinkProperties.h>
#include <gazebo_msgs/GetLinkState.h>
#include <gazebo_msgs/GetModelProperties.h>
#include <gazebo_msgs/GetModelState.h>
#include <gazebo_msgs/GetPhysicsProperties.h>
#include <gazebo_msgs/GetWorldProperties.h>
#include <gazebo_msgs/LinkState.h>
#include <gazebo_msgs/LinkStates.h>
#include <gazebo_msgs/ModelState.h>
#include <gazebo_msgs/ModelStates.h>
#include <gazebo_msgs/ODEPhysics.h>
#include <gazebo_msgs/PerformanceMetrics.h>
#include <gazebo_msgs/SetLinkState.h>
#include <gazebo_msgs/SetModelState.h>
#include <gazebo_msgs/SetPhysicsProperties.h>
#include <gazebo_msgs/SpawnModel.h>
#include <gtest/gtest.h>
#include <mav_msgs/Actuators.h>
#include <mav_msgs/AttitudeThrust.h>
#include <mav_msgs/RateThrust.h>
#include <nav_msgs/Odometry.h>
#include <ros/message_traits.h>
#include <ros/service_traits.h>
#include <rotors_comm/RecordRosbag.h>
#include <rotors_comm/WindSpeed.h>

#include <string>

namespace {

template <class Message>
std::string messageSum() {
  return ros::message_traits::md5sum<Message>();
}
template <class Service>
std::string serviceSum() {
  return ros::service_traits::md5sum<Service>();
}

TEST(WireFormats, MessagesAreThePublishedOnes) {
  EXPECT_EQ(messageSum<mav_msgs::Actuators>(), "25741daf38ed25442e3a66a855ee8d9c");
  EXPECT_EQ(messageSum<mav_msgs::AttitudeThrust>(), "7cee443b02735e42bda0ad5910302718");
  EXPECT_EQ(messageSum<mav_msgs::RateThrust>(), "119c5bf883bef42350d52ce5a7927c7c");
  EXPECT_EQ(messageSum<gazebo_msgs::LinkState>(), "0818ebbf28ce3a08d48ab1eaa7309ebe");
  EXPECT_EQ(messageSum<gazebo_msgs::LinkStates>(), "48c080191eb15c41858319b4d8a609c2");
  EXPECT_EQ(messageSum<rotors_comm::WindSpeed>(), "ae00d2a331b8545eaf96c531128ff0ef");
  EXPECT_EQ(messageSum<gazebo_msgs::ModelState>(), "9330fd35f2fcd82d457e54bd54e10593");
  EXPECT_EQ(messageSum<gazebo_msgs::ModelStates>(), "48c080191eb15c41858319b4d8a609c2");
  EXPECT_EQ(messageSum<gazebo_msgs::PerformanceMetrics>(), "884f71fd5037b886ec5e126b83c4425a");
  EXPECT_EQ(messageSum<gazebo_msgs::ODEPhysics>(), "667d56ddbd547918c32d1934503dc335");
  EXPECT_EQ(messageSum<nav_msgs::Odometry>(), "cd5e73d190d741a2f92e81eda573aca7");
}

TEST(WireFormats, ServicesAreThePublishedOnes) {
  EXPECT_EQ(serviceSum<rotors_comm::RecordRosbag>(), "5504376d5b4669d33bfb29107c817d83");
  EXPECT_EQ(serviceSum<gazebo_msgs::ApplyBodyWrench>(), "585b9f9618aa0581b207e2f2d90866bc");
  EXPECT_EQ(serviceSum<gazebo_msgs::BodyRequest>(), "5eade9afe7f232d78005bd0cafeab755");
  EXPECT_EQ(serviceSum<gazebo_msgs::DeleteModel>(), "9ce56b4e9e54616de25d796dc972a262");
  EXPECT_EQ(serviceSum<gazebo_msgs::GetJointProperties>(), "7b30be900f50aa21efec4a0ec92d91c9");
  EXPECT_EQ(serviceSum<gazebo_msgs::GetLinkProperties>(), "0e06a70386d0ee3fb880c02f23fcd821");
  EXPECT_EQ(serviceSum<gazebo_msgs::GetLinkState>(), "09d6c98cce97b35f7ab9bd70300657ab");
  EXPECT_EQ(serviceSum<gazebo_msgs::GetModelProperties>(), "5717f7bd34ed990fa80e28b3015027a3");
  EXPECT_EQ(serviceSum<gazebo_msgs::SetLinkState>(), "8a5146eb66ae4d26b0860b08f3f271be");
  EXPECT_EQ(serviceSum<gazebo_msgs::SpawnModel>(), "9ed9c82c96abe1a00c3e8cdaeee24413");
  EXPECT_EQ(serviceSum<gazebo_msgs::SetModelState>(), "5b3ab0281d4f5445def017e3a2e4a07b");
  EXPECT_EQ(serviceSum<gazebo_msgs::GetModelState>(), "4c515e936d3319c9610c559c60bfc3d4");
  EXPECT_EQ(serviceSum<gazebo_msgs::GetWorldProperties>(), "36bb0f2eccf4d8be971410c22818ba3f");
  EXPECT_EQ(serviceSum<gazebo_msgs::GetPhysicsProperties>(), "575a5e74786981b7df2e3afc567693a6");
  EXPECT_EQ(serviceSum<gazebo_msgs::SetPhysicsProperties>(), "97e2057080558ce4730434b5fae75c91");
}

}  // namespace
