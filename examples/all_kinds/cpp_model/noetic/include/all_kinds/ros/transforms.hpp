// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__ROS__TRANSFORMS_HPP_
#define ALL_KINDS__ROS__TRANSFORMS_HPP_

#include <array>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "all_kinds/ros/time.hpp"

namespace all_kinds
{

/// Looks up transforms from tf.
///
/// This base class, for tests without ROS, finds none.
template<typename Transform>
class TransformListener
{
public:
  using Seconds = std::chrono::duration<double>;

  virtual ~TransformListener() = default;

  /// Return the transform from one frame to another.
  ///
  /// \param target The frame to transform into.
  /// \param source The frame to transform from.
  /// \param timeout Wall time to wait for the transform; stopping the node ends the wait.
  /// \param stamp When the transform held, e.g. a message's stamp; by default, the latest.
  /// \return The transform, or nothing if it is not available in time.
  std::optional<Transform> lookup(
    const std::string & target,
    const std::string & source,
    Seconds timeout = Seconds::zero(),
    Time stamp = Time())
  {
    std::string reason;
    const auto transform = wait_for_transform(target, source, timeout, stamp, reason);
    const std::lock_guard<std::mutex> lock(mutex_);
    reason_ = transform ? "" : reason;
    return transform;
  }

  /// Return why the last lookup found nothing; empty if it found its transform.
  std::string reason()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return reason_;
  }

protected:
  virtual std::optional<Transform> wait_for_transform(
    const std::string & /* target */,
    const std::string & /* source */,
    Seconds /* timeout */,
    Time /* stamp */,
    std::string & reason)
  {
    reason = "There is no tf.";
    return std::nullopt;
  }

private:
  std::mutex mutex_;
  std::string reason_;
};

/// Publishes transforms to tf.
///
/// This base class, for tests without ROS, drops them.
template<typename Transform>
class TransformBroadcaster
{
public:
  using Translation = std::array<double, 3>;
  using Rotation = std::array<double, 4>;

  virtual ~TransformBroadcaster() = default;

  /// Publish the pose of a frame in its parent frame, stamped with the current time.
  ///
  /// \param parent The parent frame.
  /// \param child The child frame.
  /// \param translation x, y, z in metres.
  /// \param rotation x, y, z, w of a unit quaternion.
  void broadcast(
    const std::string & parent,
    const std::string & child,
    const Translation & translation,
    const Rotation & rotation)
  {
    send(make_transform(parent, child, translation, rotation));
  }

  /// Publish a pose that never changes; later listeners receive it too.
  void broadcast_static(
    const std::string & parent,
    const std::string & child,
    const Translation & translation,
    const Rotation & rotation)
  {
    send_static(make_transform(parent, child, translation, rotation));
  }

  /// Publish a transform as given.
  virtual void send(const Transform & /* transform */) {}

  /// Publish a static transform as given.
  virtual void send_static(const Transform & /* transform */) {}

protected:
  virtual void set_stamp(Transform & /* transform */) {}

private:
  Transform make_transform(
    const std::string & parent,
    const std::string & child,
    const Translation & translation,
    const Rotation & rotation)
  {
    Transform message;
    set_stamp(message);
    message.header.frame_id = parent;
    message.child_frame_id = child;
    message.transform.translation.x = translation[0];
    message.transform.translation.y = translation[1];
    message.transform.translation.z = translation[2];
    message.transform.rotation.x = rotation[0];
    message.transform.rotation.y = rotation[1];
    message.transform.rotation.z = rotation[2];
    message.transform.rotation.w = rotation[3];
    return message;
  }
};

}  // namespace all_kinds

#endif  // ALL_KINDS__ROS__TRANSFORMS_HPP_
