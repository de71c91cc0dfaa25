// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef ROS__PROCESS_HPP_
#define ROS__PROCESS_HPP_

#include <atomic>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <thread>

#include "ros/console.h"
#include "ros/init.h"
#include "ros/master.h"

#include "ros_log.hpp"
#include "sending.hpp"
#include "stop_requests.hpp"
#include "supervisor.hpp"
#include "thread_name.hpp"

namespace contact_analysis
{

/// End the start of a node that waits for a master.
inline void shut_down_without_master()
{
  if (!ros::master::check()) {
    ros::requestShutdown();
  }
}

/// Run a node from its start to its end; return the exit code.
///
/// Its life runs in a thread of its own, `logic`, so that this one can see to its end.
template<typename Node>
int run_node(int argc, char ** argv, const std::string & name)
{
  ros::init(argc, argv, name, ros::init_options::NoSigintHandler);
  Supervisor supervisor;
  std::atomic<bool> is_starting{true};
  const StopRequests requests(
    [&] {
      supervisor.stop();
      if (is_starting) {  // in a thread of its own, since a master may never answer
        std::thread(shut_down_without_master).detach();
      }
    },
    [&] {return supervisor.end_limit();});
  set_log_level();
  std::unique_ptr<Node> node;
  try {
    ros::start();  // else the log would end with the handles of a node that cannot be made
    node = std::make_unique<Node>(supervisor);
  } catch (const std::exception & error) {
    supervisor.fail(error.what());
  }
  is_starting = false;
  if (node && !supervisor.stopping()) {
    std::thread logic(
      [&] {
        name_this_thread("logic");
        node->live();
        supervisor.end();
      });
    supervisor.wait_for_stop();
    requests.start_limit();
    if (supervisor.watch()) {
      logic.join();
    } else {
      logic.detach();
      node->abort_goals();
    }
    wait_for_sending();
  }
  if (supervisor.late()) {
    // What still runs uses the node: neither it nor what is static may be destroyed.
    ros::shutdown();
    std::fflush(nullptr);
    _exit(1);
  }
  node.reset();
  ros::shutdown();
  return supervisor.failed() ? 1 : 0;
}

}  // namespace contact_analysis

#endif  // ROS__PROCESS_HPP_
