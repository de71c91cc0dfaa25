// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__STOP_REQUESTS_HPP_
#define ROS__STOP_REQUESTS_HPP_

#include <semaphore.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <functional>
#include <future>
#include <string>
#include <thread>
#include <utility>

#include "ros/console.h"
#include "ros/xmlrpc_manager.h"

#include "thread_name.hpp"

namespace serving
{

/// Hears SIGINT, SIGTERM and `rosnode kill`, in place of roscpp, which would end communication.
class StopRequests
{
public:
  /// Call `stop` at the first request, then give the process `limit` to end. Before ros::start.
  StopRequests(std::function<void()> stop, std::function<std::chrono::duration<double>()> limit)
  : stop_(std::move(stop)),
    limit_(std::move(limit))
  {
    sem_init(&wake_up(), 0, 0);
    std::signal(SIGINT, handle_signal);
    std::signal(SIGTERM, handle_signal);
    // ros::start leaves this in place, since it binds what is not yet bound.
    ros::XMLRPCManager::instance()->bind("shutdown", handle_shutdown);
    thread_ = std::thread([this] {wait();});
  }

  StopRequests(const StopRequests &) = delete;
  StopRequests & operator=(const StopRequests &) = delete;

  ~StopRequests()
  {
    ended_.set_value();
    sem_post(&wake_up());
    thread_.join();
  }

  /// Give the process its limit, though nobody has asked it to stop.
  void start_limit() const {sem_post(&wake_up());}

private:
  /// A semaphore, since a signal handler may do no more than post it.
  static sem_t & wake_up()
  {
    static sem_t semaphore;
    return semaphore;
  }

  static void handle_signal([[maybe_unused]] int signal)
  {
    // A second signal ends the process at once.
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    sem_post(&wake_up());
  }

  static void handle_shutdown(XmlRpc::XmlRpcValue & parameters, XmlRpc::XmlRpcValue & result)
  {
    if (parameters.getType() == XmlRpc::XmlRpcValue::TypeArray && parameters.size() > 1) {
      const std::string reason = parameters[1];
      ROS_WARN("Shutdown request received: %s", reason.c_str());
      sem_post(&wake_up());
    }
    result = ros::xmlrpc::responseInt(1, "", 0);
  }

  void wait()
  {
    name_this_thread("stop_requests");
    while (sem_wait(&wake_up()) != 0) {
    }
    const auto ended = ended_.get_future();
    if (ended.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
      return;
    }
    stop_();
    if (ended.wait_for(limit_()) != std::future_status::ready) {
      // Without ROS, whose log may ask the master first.
      std::fputs("The node does not end: its process is ended.\n", stderr);
      std::fflush(nullptr);
      _exit(1);
    }
  }

  std::function<void()> stop_;
  std::function<std::chrono::duration<double>()> limit_;
  std::promise<void> ended_;
  std::thread thread_;
};

}  // namespace serving

#endif  // ROS__STOP_REQUESTS_HPP_
