// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS_SERVICE_CLIENT_HPP_
#define ROS_SERVICE_CLIENT_HPP_

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "ros/init.h"
#include "ros/service.h"

#include "all_kinds/service_client.hpp"

namespace all_kinds
{

/// Calls a service with a timeout, which roscpp does not offer.
template<typename Service>
class RosServiceClient : public ServiceClient<Service>
{
public:
  using typename ServiceClient<Service>::Request;
  using typename ServiceClient<Service>::Response;
  using typename ServiceClient<Service>::Seconds;

  explicit RosServiceClient(const std::string & name)
  : name_(name)
  {
  }

  bool is_ready() override {return ros::service::exists(name_, false);}

protected:
  std::optional<Response> wait_for_response(const Request & request, Seconds timeout) override
  {
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(timeout);
    // This thread outlives a call that times out.
    std::packaged_task<std::optional<Response>()> task(
      [name = name_, request, end] {return call_until(end, name, request);});
    auto response = task.get_future();
    std::thread(std::move(task)).detach();
    if (response.wait_until(end) != std::future_status::ready) {
      return std::nullopt;
    }
    return response.get();
  }

private:
  using Clock = std::chrono::steady_clock;

  static std::optional<Response> call_until(
    Clock::time_point end,
    const std::string & name,
    Request request)
  {
    while (!ros::service::exists(name, false)) {
      if (Clock::now() >= end || !ros::ok()) {
        return std::nullopt;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    Response response;
    if (!ros::service::call(name, request, response)) {
      return std::nullopt;
    }
    return response;
  }

  std::string name_;
};

}  // namespace all_kinds

#endif  // ROS_SERVICE_CLIENT_HPP_
