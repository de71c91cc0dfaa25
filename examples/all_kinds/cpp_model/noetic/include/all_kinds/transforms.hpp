// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__TRANSFORMS_HPP_
#define ALL_KINDS__TRANSFORMS_HPP_

#include <array>
#include <chrono>
#include <optional>
#include <string>

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

  /// Return the latest transform from one frame to another.
  ///
  /// \param target The frame to transform into.
  /// \param source The frame to transform from.
  /// \param timeout Time to wait for the transform.
  /// \return The transform, or nothing if it is not available in time.
  std::optional<Transform> lookup(
    const std::string & target,
    const std::string & source,
    Seconds timeout = Seconds::zero())
  {
    return wait_for_transform(target, source, timeout);
  }

protected:
  virtual std::optional<Transform> wait_for_transform(
    const std::string & /* target */,
    const std::string & /* source */,
    Seconds /* timeout */)
  {
    return std::nullopt;
  }
};

/// Publishes transforms to tf.
///
/// This base class, for tests without ROS, drops them.
template<typename Transform>
class TransformBroadcaster
{
public:
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
    const std::array<double, 3> & translation,
    const std::array<double, 4> & rotation)
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
    send(message);
  }

  /// Publish a transform as given.
  virtual void send(const Transform & /* transform */) {}

protected:
  virtual void set_stamp(Transform & /* transform */) {}
};

}  // namespace all_kinds

#endif  // ALL_KINDS__TRANSFORMS_HPP_
