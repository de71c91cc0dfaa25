// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef ROS__SENDING_HPP_
#define ROS__SENDING_HPP_

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>

#include "ros/poll_manager.h"

namespace contact_analysis
{

/// Wait until roscpp's own thread has sent what was published, half a second at most.
///
/// In one round of that thread, messages go from publishers to connections; in the next, they are
/// written.
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
    rounds->changed.wait_for(
      lock, std::chrono::milliseconds(500), [&] {return rounds->left <= 0;});
  }
  poll->removePollThreadListener(listener);
}

}  // namespace contact_analysis

#endif  // ROS__SENDING_HPP_
