// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__CALLBACK_THREAD_HPP_
#define ROS__CALLBACK_THREAD_HPP_

#include <string>

#include "ros/callback_queue.h"
#include "ros/node_handle.h"

#include "receiver.hpp"

namespace serving
{

/// A thread for the callbacks of one node handle.
class CallbackThread : public Receiver
{
public:
  CallbackThread(const ros::NodeHandle & node, const std::string & name)
  : Receiver(name),
    node_(node)
  {
    node_.setCallbackQueue(&queue_);
    start(
      [this] {
        while (queue_.isEnabled()) {
          queue_.callOne(ros::WallDuration(60.0));
        }
      });
  }

  ~CallbackThread() override {join();}

  /// Return the node handle whose callbacks run in this thread.
  ros::NodeHandle & node() {return node_;}

  void stop() final {queue_.disable();}

private:
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
};

}  // namespace serving

#endif  // ROS__CALLBACK_THREAD_HPP_
