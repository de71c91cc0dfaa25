// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__PROCESS_HPP_
#define ROS__PROCESS_HPP_

#include <semaphore.h>
#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "ros/console.h"
#include "ros/init.h"
#include "ros/master.h"
#include "ros/poll_manager.h"
#include "ros/xmlrpc_manager.h"

#include "ros_log.hpp"
#include "stop.hpp"
#include "supervisor.hpp"

namespace all_kinds
{

/// Hears SIGINT, SIGTERM and `rosnode kill`: roscpp 1.15 itself would end communication first.
class StopRequests
{
public:
  /// Call `stop` at the first request, then give the process `limit` to end.
  StopRequests(std::function<void()> stop, std::function<Stop::Seconds()> limit)
  : stop_(std::move(stop)),
    limit_(std::move(limit))
  {
    sem_init(&wake_up(), 0, 0);
    std::signal(SIGINT, handle_signal);
    std::signal(SIGTERM, handle_signal);
    // Before ros::start, which binds only names that are not bound yet.
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

  /// Limit the time that the process has left, also after a failure.
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
    if (ended.wait_for(Stop::Seconds(0.0)) == std::future_status::ready) {
      return;
    }
    stop_();
    if (ended.wait_for(limit_()) != std::future_status::ready) {
      // Not by the log, as roscpp 1.15 may ask the master before it logs.
      std::fputs("The node does not end in time: its process is killed.\n", stderr);
      std::fflush(nullptr);
      _exit(1);
    }
  }

  std::function<void()> stop_;
  std::function<Stop::Seconds()> limit_;
  std::promise<void> ended_;
  std::thread thread_;
};

/// Wait until roscpp has sent what was published: 1.15 has no function for that.
///
/// In one round of its poll thread, messages go from publishers to connections; in the next, they
/// are written.
inline void wait_for_sending()
{
  struct Rounds
  {
    std::mutex mutex;
    std::condition_variable changed;
    int left = 3;
  };
  const auto rounds = std::make_shared<Rounds>();
  const auto poll = ros::PollManager::instance();
  const auto listener = poll->addPollThreadListener(
    [rounds, poll = poll.get()] {
      const std::lock_guard<std::mutex> lock(rounds->mutex);
      if (--rounds->left > 0) {
        poll->getPollSet().signal();
      }
      rounds->changed.notify_all();
    });
  poll->getPollSet().signal();
  {
    std::unique_lock<std::mutex> lock(rounds->mutex);
    rounds->changed.wait_for(lock, timeouts::SEND, [&] {return rounds->left <= 0;});
  }
  poll->removePollThreadListener(listener);
}

/// Run a node from its start to its end; return the exit code.
///
/// The logic has its own thread, `logic`; this one waits for the stop and enforces its limits.
template<typename Node>
int run_node(int argc, char ** argv, const std::string & name)
{
  ros::init(argc, argv, name, ros::init_options::NoSigintHandler);
  Supervisor supervisor;
  std::atomic<bool> is_starting{true};
  const StopRequests requests(
    [&] {
      supervisor.stop();
      if (is_starting) {  // it may wait for a master, which may never answer
        std::thread([] {if (!ros::master::check()) {ros::requestShutdown();}}).detach();
      }
    },
    [&] {return supervisor.end_limit();});
  set_log_level();
  std::unique_ptr<Node> node;
  try {
    ros::start();  // else ROS ends, and with it the log, when making the node throws
    if (!supervisor.stopping()) {  // ros::start returns when a node that has no master is stopped
      node = std::make_unique<Node>(supervisor);
    }
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

}  // namespace all_kinds

#endif  // ROS__PROCESS_HPP_
