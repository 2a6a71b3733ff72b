#include "ros_graph.hpp"

#include <ros/ros.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace quad_experiment {
namespace {

using Json = nlohmann::ordered_json;
using NodesByName = std::map<std::string, std::set<std::string>>;

/// One of the three lists of getSystemState: [[name, [node, …]], …].
NodesByName nodesByName(XmlRpc::XmlRpcValue& list) {
  NodesByName result;
  for (int i = 0; i < list.size(); ++i) {
    for (int j = 0; j < list[i][1].size(); ++j)
      result[std::string(list[i][0])].insert(std::string(list[i][1][j]));
  }
  return result;
}

bool askMaster(const std::string& method, XmlRpc::XmlRpcValue& answer) {
  XmlRpc::XmlRpcValue request, response;
  request[0] = ros::this_node::getName();
  return ros::master::execute(method, request, response, answer, /*wait_for_master=*/false);
}

}  // namespace

Json rosGraph() {
  XmlRpc::XmlRpcValue state, types;
  if (!askMaster("getSystemState", state) || !askMaster("getTopicTypes", types)) return nullptr;
  const NodesByName publishers = nodesByName(state[0]), subscribers = nodesByName(state[1]),
                    services = nodesByName(state[2]);
  std::set<std::string> nodes;
  std::map<std::string, Json> topics;
  for (const NodesByName* lists : {&publishers, &subscribers, &services}) {
    for (const auto& [name, users] : *lists) {
      nodes.insert(users.begin(), users.end());
      if (lists != &services)
        topics[name] = {
            {"type", "*"}, {"publishers", Json::array()}, {"subscribers", Json::array()}};
    }
  }
  for (const auto& [name, users] : publishers) topics[name]["publishers"] = users;
  for (const auto& [name, users] : subscribers) topics[name]["subscribers"] = users;
  for (int i = 0; i < types.size(); ++i) {
    const auto topic = topics.find(std::string(types[i][0]));
    if (topic != topics.end()) topic->second["type"] = std::string(types[i][1]);
  }
  return {{"nodes", nodes}, {"topics", topics}, {"services", services}};
}

}  // namespace quad_experiment
