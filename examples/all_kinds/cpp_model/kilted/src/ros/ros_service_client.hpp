// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_SERVICE_CLIENT_HPP_
#define ROS__ROS_SERVICE_CLIENT_HPP_

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "rclcpp/client.hpp"
#include "rclcpp/qos.hpp"

#include "all_kinds/ros/service_client.hpp"
#include "managed_node.hpp"
#include "stop.hpp"

namespace all_kinds
{

/// Calls a service from any thread: the response comes in a thread of the client.
template<typename Service>
class RosServiceClient : public ServiceClient<Service>
{
public:
  using typename ServiceClient<Service>::Request;
  using typename ServiceClient<Service>::Response;
  using typename ServiceClient<Service>::Seconds;

  RosServiceClient(
    ManagedNode & node, const std::string & name, const rclcpp::QoS & qos = rclcpp::ServicesQoS())
  : stop_(node.stop()),
    client_(
      waking(
        node.create_client<Service>(
          name,
          qos,
          node.callback_group("service", name)),
        node.callback_group("service", name)))
  {
  }

  bool is_ready() override
  {
    try {
      return client_->service_is_ready();
    } catch (const std::exception &) {
      return false;  // The context is shut down.
    }
  }

protected:
  std::optional<Response> wait_for_response(const Request & request, Seconds timeout) override
  {
    const auto end = Stop::deadline(timeout);
    if (!stop_->poll_until(end, [this] {return is_ready();})) {
      return std::nullopt;
    }
    try {
      return wait_for_answer(request, end);
    } catch (const std::exception &) {
      return std::nullopt;  // The context is shut down.
    }
  }

private:
  using Answer = std::shared_ptr<Response>;

  std::optional<Response> wait_for_answer(const Request & request, Stop::Clock::time_point end)
  {
    const auto answer = std::make_shared<Answer>();
    const auto call = client_->async_send_request(
      std::make_shared<Request>(request),
      [answer, stop = stop_](typename rclcpp::Client<Service>::SharedFuture response) {
        stop->change([&] {*answer = response.get();});
      });
    if (!stop_->wait_until(end, [&] {return *answer != nullptr;})) {
      client_->remove_pending_request(call.request_id);
      return std::nullopt;
    }
    return std::move(**answer);
  }

  std::shared_ptr<Stop> stop_;
  std::shared_ptr<rclcpp::Client<Service>> client_;
};

}  // namespace all_kinds

#endif  // ROS__ROS_SERVICE_CLIENT_HPP_
