// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_TRANSFORMS_HPP_
#define ROS__ROS_TRANSFORMS_HPP_

#include <optional>
#include <string>

#include "geometry_msgs/TransformStamped.h"
#include "tf2/exceptions.h"
#include "tf2_ros/buffer.h"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"
#include "tf2_ros/transform_listener.h"

#include "all_kinds/ros/transforms.hpp"
#include "callback_thread.hpp"
#include "stop.hpp"

namespace all_kinds
{

/// Looks up transforms from tf, which it receives in a thread of its own.
class RosTransformListener : public TransformListener<geometry_msgs::TransformStamped>
{
public:
  explicit RosTransformListener(Stop & stop)
  : stop_(stop)
  {
  }

protected:
  std::optional<geometry_msgs::TransformStamped> wait_for_transform(
    const std::string & target,
    const std::string & source,
    Seconds timeout,
    Time stamp,
    std::string & reason) override
  {
    std::optional<geometry_msgs::TransformStamped> found;
    stop_.poll_until(
      Stop::deadline(timeout), [&] {
        try {
          found = buffer_.lookupTransform(target, source, stamp);
        } catch (const tf2::TransformException & error) {
          reason = error.what();
        }
        return found.has_value();
      });
    return found;
  }

private:
  Stop & stop_;
  tf2_ros::Buffer buffer_;
  CallbackThread thread_{ros::NodeHandle(), "tf"};
  tf2_ros::TransformListener listener_{buffer_, thread_.node(), false};
};

/// Publishes transforms to tf.
class RosTransformBroadcaster : public TransformBroadcaster<geometry_msgs::TransformStamped>
{
public:
  void send(const geometry_msgs::TransformStamped & transform) override
  {
    broadcaster_.sendTransform(transform);
  }

  void send_static(const geometry_msgs::TransformStamped & transform) override
  {
    static_broadcaster_.sendTransform(transform);
  }

protected:
  void set_stamp(geometry_msgs::TransformStamped & transform) override
  {
    transform.header.stamp = ros::Time::now();
  }

private:
  tf2_ros::TransformBroadcaster broadcaster_;
  tf2_ros::StaticTransformBroadcaster static_broadcaster_;
};

}  // namespace all_kinds

#endif  // ROS__ROS_TRANSFORMS_HPP_
