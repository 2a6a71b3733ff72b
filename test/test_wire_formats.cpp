// The messages of other people's programs: ROS 1 connects only where name and MD5 sum agree.
#include <gazebo_msgs/GetModelState.h>
#include <gazebo_msgs/GetPhysicsProperties.h>
#include <gazebo_msgs/GetWorldProperties.h>
#include <gazebo_msgs/ModelState.h>
#include <gazebo_msgs/ModelStates.h>
#include <gazebo_msgs/ODEPhysics.h>
#include <gazebo_msgs/SetModelState.h>
#include <gazebo_msgs/SetPhysicsProperties.h>
#include <gtest/gtest.h>
#include <mav_msgs/Actuators.h>
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
  EXPECT_EQ(messageSum<rotors_comm::WindSpeed>(), "ae00d2a331b8545eaf96c531128ff0ef");
  EXPECT_EQ(messageSum<gazebo_msgs::ModelState>(), "9330fd35f2fcd82d457e54bd54e10593");
  EXPECT_EQ(messageSum<gazebo_msgs::ModelStates>(), "48c080191eb15c41858319b4d8a609c2");
  EXPECT_EQ(messageSum<gazebo_msgs::ODEPhysics>(), "667d56ddbd547918c32d1934503dc335");
  EXPECT_EQ(messageSum<nav_msgs::Odometry>(), "cd5e73d190d741a2f92e81eda573aca7");
}

TEST(WireFormats, ServicesAreThePublishedOnes) {
  EXPECT_EQ(serviceSum<rotors_comm::RecordRosbag>(), "5504376d5b4669d33bfb29107c817d83");
  EXPECT_EQ(serviceSum<gazebo_msgs::SetModelState>(), "5b3ab0281d4f5445def017e3a2e4a07b");
  EXPECT_EQ(serviceSum<gazebo_msgs::GetModelState>(), "4c515e936d3319c9610c559c60bfc3d4");
  EXPECT_EQ(serviceSum<gazebo_msgs::GetWorldProperties>(), "36bb0f2eccf4d8be971410c22818ba3f");
  EXPECT_EQ(serviceSum<gazebo_msgs::GetPhysicsProperties>(), "575a5e74786981b7df2e3afc567693a6");
  EXPECT_EQ(serviceSum<gazebo_msgs::SetPhysicsProperties>(), "97e2057080558ce4730434b5fae75c91");
}

}  // namespace
