// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__SERVICE_CALLER_HPP_
#define ROS__SERVICE_CALLER_HPP_

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "ros/connection.h"
#include "ros/serialized_message.h"
#include "ros/service.h"
#include "ros/service_manager.h"
#include "ros/service_server_link.h"

#include "stop.hpp"

namespace all_kinds
{

/// Calls a service in a thread of its own, since calls of roscpp 1.15 have no timeout.
///
/// The connection is kept from call to call, and dropped when a call times out.
class ServiceCaller
{
public:
  ServiceCaller(const std::string & service, const std::string & md5sum, Stop & stop)
  : service_(service),
    md5sum_(md5sum),
    stop_(stop),
    thread_([this] {work();})
  {
  }

  ServiceCaller(const ServiceCaller &) = delete;
  ServiceCaller & operator=(const ServiceCaller &) = delete;

  ~ServiceCaller()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ended_ = true;
    }
    give_up();
    thread_.join();
  }

  /// Reserve the caller for a call; return false if another call is under way.
  bool take()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(taken_, true) == false;
  }

  /// Return the response; nothing at `end` or when the node stops. Call `take` first.
  std::optional<ros::SerializedMessage> call(
    const ros::SerializedMessage & request,
    Stop::Clock::time_point end)
  {
    const auto call = std::make_shared<Call>();
    call->request = request;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      call_ = call;
    }
    changed_.notify_one();
    if (stop_.wait_until(end, [&] {return call->done;})) {
      return call->response;
    }
    give_up();
    return std::nullopt;
  }

private:
  struct Call
  {
    ros::SerializedMessage request;
    std::optional<ros::SerializedMessage> response;
    bool done = false;
  };

  void work()
  {
    name_this_thread(service_);
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] {return ended_ || call_;});
      const auto call = call_;
      if (!call) {
        return;
      }
      lock.unlock();
      auto response = response_to(*call);
      stop_.change(
        [&] {
          call->response = std::move(response);
          call->done = true;
          lock.lock();  // within the change: further calls wait for this caller to be free
          call_ = nullptr;
          taken_ = false;
        });
    }
  }

  /// Return the response; nothing if the server gives none, or nobody waits for it any more.
  std::optional<ros::SerializedMessage> response_to(const Call & call)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (call_) {
      auto link = link_;
      // A link of roscpp 1.15 does not notice a connection that was refused at once.
      if (!link || link->getConnection()->isDropped()) {
        lock.unlock();
        link = connect();
        lock.lock();
        link_ = link;
      }
      if (!link) {
        changed_.wait_for(lock, timeouts::RETRY, [this] {return !call_;});
      } else if (call_) {
        lock.unlock();
        ros::SerializedMessage response;
        if (link->call(call.request, response)) {
          return response;
        }
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  /// Return a connection to the server, if there is one.
  ros::ServiceServerLinkPtr connect()
  {
    // Checked first, as roscpp 1.15 may dead-lock when it connects to a server that has died.
    if (!ros::service::exists(service_, false)) {
      return nullptr;
    }
    return ros::ServiceManager::instance()->createServiceServerLink(
      service_, true, md5sum_, md5sum_, ros::M_string());
  }

  /// Abandon the current call: close its connection, so that its thread returns.
  void give_up()
  {
    ros::ServiceServerLinkPtr link;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      call_ = nullptr;
      link.swap(link_);
    }
    changed_.notify_one();
    if (link) {
      link->getConnection()->drop(ros::Connection::Destructing);
    }
  }

  std::string service_;
  std::string md5sum_;
  Stop & stop_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<Call> call_;
  ros::ServiceServerLinkPtr link_;
  bool taken_ = false;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace all_kinds

#endif  // ROS__SERVICE_CALLER_HPP_
