// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS_SERVICE_CLIENT_HPP_
#define ROS_SERVICE_CLIENT_HPP_

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "rclcpp/client.hpp"
#include "rclcpp/executors/single_threaded_executor.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include "all_kinds/service_client.hpp"
#include "own_executor.hpp"

namespace all_kinds
{

/// Calls a service from any thread: an executor of its own receives the response.
template<typename Service>
class RosServiceClient : public ServiceClient<Service>
{
public:
  using typename ServiceClient<Service>::Request;
  using typename ServiceClient<Service>::Response;
  using typename ServiceClient<Service>::Seconds;

  RosServiceClient(rclcpp_lifecycle::LifecycleNode & node, const std::string & name)
  : group_(make_own_group(node)),
    client_(
      node.create_client<Service>(
        name,
        rclcpp::ServicesQoS(),
        group_)),
    executor_(make_executor_options(node))
  {
    executor_.add_callback_group(group_, node.get_node_base_interface());
  }

  bool is_ready() override {return client_->service_is_ready();}

protected:
  std::optional<Response> wait_for_response(const Request & request, Seconds timeout) override
  {
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(timeout);
    const std::unique_lock<std::timed_mutex> lock(mutex_, end);
    if (!lock || !client_->wait_for_service(until(end))) {
      return std::nullopt;
    }
    auto call = client_->async_send_request(std::make_shared<Request>(request));
    const auto outcome = executor_.spin_until_future_complete(call, until(end));
    if (outcome != rclcpp::FutureReturnCode::SUCCESS) {
      client_->remove_pending_request(call);
      return std::nullopt;
    }
    return std::move(*call.future.get());
  }

private:
  using Clock = std::chrono::steady_clock;

  /// Return the remaining time, never negative: that would mean no timeout.
  static std::chrono::nanoseconds until(Clock::time_point end)
  {
    return std::max<std::chrono::nanoseconds>(end - Clock::now(), std::chrono::nanoseconds(0));
  }

  std::timed_mutex mutex_;
  rclcpp::CallbackGroup::SharedPtr group_;
  std::shared_ptr<rclcpp::Client<Service>> client_;
  rclcpp::executors::SingleThreadedExecutor executor_;
};

}  // namespace all_kinds

#endif  // ROS_SERVICE_CLIENT_HPP_
