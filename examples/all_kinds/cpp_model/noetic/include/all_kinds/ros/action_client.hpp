// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__ROS__ACTION_CLIENT_HPP_
#define ALL_KINDS__ROS__ACTION_CLIENT_HPP_

#include <memory>

namespace all_kinds
{

/// The state of an action client's goal; lost: there is no server, or it has died.
enum class ActionState {idle, pending, active, rejected, succeeded, aborted, canceled, lost};

/// Return the name of a state.
inline const char * to_string(ActionState state)
{
  switch (state) {
    case ActionState::idle:
      return "idle";
    case ActionState::pending:
      return "pending";
    case ActionState::active:
      return "active";
    case ActionState::rejected:
      return "rejected";
    case ActionState::succeeded:
      return "succeeded";
    case ActionState::aborted:
      return "aborted";
    case ActionState::canceled:
      return "canceled";
    default:
      return "lost";
  }
}

/// An action client with one goal at a time; no method blocks.
///
/// This base class, for tests without ROS, finds no server.
template<typename Action>
class ActionClient
{
public:
  using Goal = typename Action::Goal;
  using Feedback = typename Action::Feedback;
  using Result = typename Action::Result;

  virtual ~ActionClient() = default;

  /// Return whether a server is available.
  virtual bool is_ready() {return false;}

  /// Send a goal, replacing the previous one; return false if no server is available.
  virtual bool send_goal(const Goal & /* goal */) {return false;}

  /// Ask the server to cancel the goal, even if it has not answered yet.
  virtual void cancel() {}

  /// Return the state of the goal.
  virtual ActionState state() {return ActionState::idle;}

  /// Return the latest feedback, or nullptr.
  virtual std::shared_ptr<const Feedback> feedback() {return nullptr;}

  /// Return the result once the goal has ended, or nullptr.
  virtual std::shared_ptr<const Result> result() {return nullptr;}
};

}  // namespace all_kinds

#endif  // ALL_KINDS__ROS__ACTION_CLIENT_HPP_
