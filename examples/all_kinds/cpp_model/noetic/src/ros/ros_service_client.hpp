// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_SERVICE_CLIENT_HPP_
#define ROS__ROS_SERVICE_CLIENT_HPP_

#include <list>
#include <mutex>
#include <optional>
#include <string>

#include "ros/names.h"
#include "ros/serialization.h"
#include "ros/service.h"
#include "ros/service_traits.h"

#include "all_kinds/ros/service_client.hpp"
#include "service_caller.hpp"

namespace all_kinds
{

/// Calls a service with a timeout, which roscpp 1.15 does not offer.
template<typename Service>
class RosServiceClient : public ServiceClient<Service>
{
public:
  using typename ServiceClient<Service>::Request;
  using typename ServiceClient<Service>::Response;
  using typename ServiceClient<Service>::Seconds;

  RosServiceClient(const std::string & name, Stop & stop)
  : name_(ros::names::resolve(name)),
    stop_(stop)
  {
  }

  bool is_ready() override {return ros::service::exists(name_, false);}

protected:
  std::optional<Response> wait_for_response(const Request & request, Seconds timeout) override
  {
    const auto end = Stop::deadline(timeout);
    ServiceCaller * caller = nullptr;
    if (!stop_.wait_until(end, [&] {return (caller = take_caller()) != nullptr;})) {
      return std::nullopt;
    }
    const auto serialized = caller->call(ros::serialization::serializeMessage(request), end);
    if (!serialized) {
      return std::nullopt;
    }
    Response response;
    ros::serialization::deserializeMessage(*serialized, response);
    return response;
  }

private:
  /// Further calls wait. Calls may pile up where roscpp blocks, as the master does not answer.
  static constexpr std::size_t MAX_CALLERS = 32;

  /// Return a caller without a call, if there may be one.
  ServiceCaller * take_caller()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (auto & caller : callers_) {
      if (caller.take()) {
        return &caller;
      }
    }
    if (callers_.size() == MAX_CALLERS) {
      return nullptr;
    }
    auto & caller =
      callers_.emplace_back(name_, ros::service_traits::md5sum<Service>(), stop_);
    caller.take();
    return &caller;
  }

  std::string name_;
  Stop & stop_;
  std::mutex mutex_;
  std::list<ServiceCaller> callers_;
};

}  // namespace all_kinds

#endif  // ROS__ROS_SERVICE_CLIENT_HPP_
