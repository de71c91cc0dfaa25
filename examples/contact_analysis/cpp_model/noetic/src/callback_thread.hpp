// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef CALLBACK_THREAD_HPP_
#define CALLBACK_THREAD_HPP_

#include "ros/callback_queue.h"
#include "ros/node_handle.h"
#include "ros/spinner.h"

namespace contact_analysis
{

/// A thread for one callback, so that a blocking callback delays no other.
class CallbackThread
{
public:
  explicit CallbackThread(const ros::NodeHandle & node)
  : node_(node),
    spinner_(1, &queue_)
  {
    node_.setCallbackQueue(&queue_);
    spinner_.start();
  }

  /// Return a node handle whose callbacks run in this thread.
  ros::NodeHandle & node() {return node_;}

private:
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::AsyncSpinner spinner_;
};

}  // namespace contact_analysis

#endif  // CALLBACK_THREAD_HPP_
