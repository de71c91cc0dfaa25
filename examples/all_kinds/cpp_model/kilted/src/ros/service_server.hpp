// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__SERVICE_SERVER_HPP_
#define ROS__SERVICE_SERVER_HPP_

#include <exception>
#include <memory>
#include <string>

#include "rclcpp/qos.hpp"
#include "rclcpp/service.hpp"

#include "managed_node.hpp"

namespace all_kinds
{

/// Create a service server with a thread of its own, whose requests go to a method of the logic.
///
/// A request gets no response if the method throws or the node has stopped.
template<typename Service, typename Logic>
std::shared_ptr<void> create_service_server(
  ManagedNode & node,
  const std::string & name,
  const std::shared_ptr<Logic> & logic,
  void (Logic::* serve)(const typename Service::Request &, typename Service::Response &),
  const rclcpp::QoS & qos = rclcpp::ServicesQoS())
{
  return node.create_service<Service>(
    name,
    // A waiting executor of rclcpp 29.3 owns its services: they do not own the logic.
    [calls = node.calls(), pass = node.calls()->pass(), name,
    logic = std::weak_ptr<Logic>(logic), serve](
      std::shared_ptr<rclcpp::Service<Service>> server,
      std::shared_ptr<rmw_request_id_t> id,
      std::shared_ptr<typename Service::Request> request) {
      calls->run(
        pass, "service " + name, [&] {
          const auto owned = logic.lock();
          if (!owned) {
            return;
          }
          typename Service::Response response;
          (owned.get()->*serve)(*request, response);
          try {
            server->send_response(*id, response);
          } catch (const std::exception &) {
            // The context is shut down.
          }
        });
    },
    qos,
    node.callback_group("service", name));
}

}  // namespace all_kinds

#endif  // ROS__SERVICE_SERVER_HPP_
