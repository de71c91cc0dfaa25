// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__ROS__GOAL_HPP_
#define ALL_KINDS__ROS__GOAL_HPP_

namespace all_kinds
{

/// How the execution of a goal ended, if it did.
enum class Outcome {none, succeeded, aborted, canceled};

/// An action goal that the logic executes.
///
/// This base class, for tests without ROS, is never canceled and publishes no feedback.
template<typename Action>
class Goal
{
public:
  explicit Goal(const typename Action::Goal & goal)
  : request(goal)
  {
  }

  virtual ~Goal() = default;

  /// Return whether to return soon: the client cancels, a new goal replaces this one, or the node
  /// stops.
  virtual bool cancel_requested() {return false;}

  /// Publish the current feedback.
  virtual void publish_feedback() {}

  /// Mark the goal as succeeded. The result is sent when the callback returns.
  void succeed() {outcome_ = Outcome::succeeded;}

  /// Mark the goal as aborted.
  void abort() {outcome_ = Outcome::aborted;}

  /// Mark the goal as canceled, after cancel_requested() returned true.
  void canceled() {outcome_ = Outcome::canceled;}

  Outcome outcome() const {return outcome_;}

  const typename Action::Goal request;
  typename Action::Feedback feedback;
  typename Action::Result result;

private:
  Outcome outcome_ = Outcome::none;
};

}  // namespace all_kinds

#endif  // ALL_KINDS__ROS__GOAL_HPP_
