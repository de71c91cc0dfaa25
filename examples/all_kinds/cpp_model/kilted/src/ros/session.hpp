// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__SESSION_HPP_
#define ROS__SESSION_HPP_

#include "stop.hpp"

namespace all_kinds
{

class ManagedNode;

/// The logic of a node from configure to cleanup, with all it uses.
///
/// Threads that do not end in time keep it, whatever becomes of the node.
class Session
{
public:
  virtual ~Session() = default;

  // In the thread of the logic
  virtual bool configure() = 0;
  virtual bool activate() = 0;
  virtual void deactivate() = 0;
  virtual void cleanup() = 0;

  /// Run the cycles of the logic until the node stops.
  virtual void work() {}

  // In the thread of a transition
  /// Create subscriptions and servers.
  virtual void connect(ManagedNode & node) = 0;

  /// Ask goals that are executed to end.
  virtual void stop() {}

  /// Destroy subscriptions and servers; give every goal a result.
  virtual void disconnect() = 0;

  /// Cancel the goals that the logic has sent, within this time.
  virtual void cancel_goals(Stop::Clock::time_point /* end */) {}

  /// Wait until the last messages and results have been received, within this time.
  virtual void flush(Stop::Clock::time_point /* end */) {}
};

}  // namespace all_kinds

#endif  // ROS__SESSION_HPP_
