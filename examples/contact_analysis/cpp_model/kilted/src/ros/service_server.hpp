// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef ROS__SERVICE_SERVER_HPP_
#define ROS__SERVICE_SERVER_HPP_

#include <exception>
#include <functional>
#include <memory>
#include <string>

#include "rclcpp/qos.hpp"
#include "rclcpp/service.hpp"

#include "managed_node.hpp"

namespace contact_analysis
{

/// Create a service server with a thread of its own; `label` names it in the log.
///
/// A request gets no response if `serve` throws or the node has stopped.
template<typename Service>
std::shared_ptr<void> create_service_server(
  ManagedNode & node,
  const std::string & name,
  const std::string & label,
  const std::function<void(
    const typename Service::Request &, typename Service::Response &)> & serve)
{
  return node.create_service<Service>(
    name,
    [calls = node.calls(), pass = node.calls()->pass(), label, serve](
      std::shared_ptr<rclcpp::Service<Service>> server,
      std::shared_ptr<rmw_request_id_t> id,
      std::shared_ptr<typename Service::Request> request) {
      calls->run(
        pass, label, [&] {
          typename Service::Response response;
          serve(*request, response);
          try {
            server->send_response(*id, response);
          } catch (const std::exception &) {
            // The context is shut down.
          }
        });
    },
    rclcpp::ServicesQoS(),
    node.callback_group("service", name));
}

}  // namespace contact_analysis

#endif  // ROS__SERVICE_SERVER_HPP_
