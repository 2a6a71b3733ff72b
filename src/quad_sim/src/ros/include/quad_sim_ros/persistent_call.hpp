/// Service calls over connections that stay open. roscpp's one-off calls (ros::service::call) take
/// ten times as long, and on a busy machine a few in ten thousand return false although the server
/// has done what it was asked.
#pragma once

#include <ros/ros.h>

#include <map>
#include <string>

namespace quad_sim {

/// Calls the service `name` over `client`, which is connected first where it is not yet.
/// @returns false if nobody answers; the connection is given up then, the next call makes a new one
template <class Service>
bool persistentCall(ros::ServiceClient& client, const std::string& name, Service& call) {
  if (!client.isValid()) {
    client = ros::NodeHandle().serviceClient<Service>(name, /*persistent=*/true);
  }
  if (client.isValid() && client.call(call)) return true;
  client.shutdown();
  return false;
}

/// The same with one connection a service name for the whole process. One thread only.
template <class Service>
bool persistentCall(const std::string& name, Service& call) {
  static std::map<std::string, ros::ServiceClient> clients;
  return persistentCall(clients[name], name, call);
}

}  // namespace quad_sim
