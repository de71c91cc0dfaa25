// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__ROS_TRANSFORMS_HPP_
#define ROS__ROS_TRANSFORMS_HPP_

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/exceptions.h"
#include "tf2/time.h"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/buffer.h"
#include "tf2_ros/qos.hpp"
#include "tf2_ros/static_transform_broadcaster.h"
#include "tf2_ros/transform_broadcaster.h"

#include "all_kinds/ros/transforms.hpp"
#include "managed_node.hpp"
#include "stop.hpp"

namespace all_kinds
{

/// Looks up transforms from tf, which a thread of the node receives.
///
/// Not a tf2_ros::TransformListener: with 0.39, joining its thread may hang, and its callbacks may
/// run after its destruction. The callbacks here own the buffer.
class RosTransformListener : public TransformListener<geometry_msgs::msg::TransformStamped>
{
public:
  explicit RosTransformListener(ManagedNode & node)
  : stop_(node.stop()),
    buffer_(std::make_shared<tf2_ros::Buffer>(node.get_clock())),
    transforms_(subscribe(node, "/tf", tf2_ros::DynamicListenerQoS(), false)),
    static_transforms_(subscribe(node, "/tf_static", tf2_ros::StaticListenerQoS(), true))
  {
  }

protected:
  std::optional<geometry_msgs::msg::TransformStamped> wait_for_transform(
    const std::string & target,
    const std::string & source,
    Seconds timeout,
    Time stamp,
    std::string & reason) override
  {
    const tf2::TimePoint time(std::chrono::nanoseconds(stamp.nanoseconds()));
    std::optional<geometry_msgs::msg::TransformStamped> found;
    stop_->poll_until(
      Stop::deadline(timeout), [&] {
        try {
          found = buffer_->lookupTransform(target, source, time);
        } catch (const tf2::TransformException & error) {
          reason = error.what();
        }
        return found.has_value();
      });
    return found;
  }

private:
  using Message = tf2_msgs::msg::TFMessage;

  /// Store the transforms of a topic in the buffer.
  std::shared_ptr<void> subscribe(
    ManagedNode & node, const std::string & topic, const rclcpp::QoS & qos, bool is_static) const
  {
    rclcpp::SubscriptionOptions options;
    options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
    options.callback_group = node.callback_group("tf", "tf");
    const auto subscription = node.create_subscription<Message>(
      topic,
      qos,
      [buffer = buffer_, logger = node.get_logger(), is_static](const Message & message) {
        for (const auto & transform : message.transforms) {
          try {
            buffer->setTransform(transform, "", is_static);
          } catch (const tf2::TransformException & error) {
            RCLCPP_ERROR(logger, "A transform is not stored: %s", error.what());
          }
        }
      },
      options);
    return waking(subscription, options.callback_group);
  }

  std::shared_ptr<Stop> stop_;
  std::shared_ptr<tf2_ros::Buffer> buffer_;
  std::shared_ptr<void> transforms_;
  std::shared_ptr<void> static_transforms_;
};

/// Publishes transforms to tf.
class RosTransformBroadcaster : public TransformBroadcaster<geometry_msgs::msg::TransformStamped>
{
public:
  explicit RosTransformBroadcaster(ManagedNode & node)
  : clock_(node.get_clock()),
    broadcaster_(node),
    static_broadcaster_(node)
  {
  }

  void send(const geometry_msgs::msg::TransformStamped & transform) override
  {
    broadcaster_.sendTransform(transform);
  }

  void send_static(const geometry_msgs::msg::TransformStamped & transform) override
  {
    static_broadcaster_.sendTransform(transform);
  }

protected:
  void set_stamp(geometry_msgs::msg::TransformStamped & transform) override
  {
    transform.header.stamp = clock_->now();
  }

private:
  rclcpp::Clock::SharedPtr clock_;
  tf2_ros::TransformBroadcaster broadcaster_;
  tf2_ros::StaticTransformBroadcaster static_broadcaster_;
};

}  // namespace all_kinds

#endif  // ROS__ROS_TRANSFORMS_HPP_
