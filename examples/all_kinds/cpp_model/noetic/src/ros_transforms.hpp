// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS_TRANSFORMS_HPP_
#define ROS_TRANSFORMS_HPP_

#include <chrono>
#include <optional>
#include <string>
#include <thread>

#include "geometry_msgs/TransformStamped.h"
#include "ros/time.h"
#include "tf2/exceptions.h"
#include "tf2_ros/buffer.h"
#include "tf2_ros/transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"

#include "all_kinds/transforms.hpp"

namespace all_kinds
{

/// Looks up transforms from tf; its subscription spins in its own thread.
class RosTransformListener : public TransformListener<geometry_msgs::TransformStamped>
{
protected:
  std::optional<geometry_msgs::TransformStamped> wait_for_transform(
    const std::string & target,
    const std::string & source,
    Seconds timeout) override
  {
    const auto start = std::chrono::steady_clock::now();
    while (true) {
      try {
        return buffer_.lookupTransform(target, source, ros::Time());
      } catch (const tf2::TransformException &) {
        if (std::chrono::steady_clock::now() - start >= timeout) {
          return std::nullopt;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    }
  }

private:
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_{buffer_};
};

/// Publishes transforms to tf.
class RosTransformBroadcaster : public TransformBroadcaster<geometry_msgs::TransformStamped>
{
public:
  void send(const geometry_msgs::TransformStamped & transform) override
  {
    broadcaster_.sendTransform(transform);
  }

protected:
  void set_stamp(geometry_msgs::TransformStamped & transform) override
  {
    transform.header.stamp = ros::Time::now();
  }

private:
  tf2_ros::TransformBroadcaster broadcaster_;
};

}  // namespace all_kinds

#endif  // ROS_TRANSFORMS_HPP_
