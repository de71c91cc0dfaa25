// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef CONTACT_ANALYSIS__GOAL_HPP_
#define CONTACT_ANALYSIS__GOAL_HPP_

namespace contact_analysis
{

/// How the work on a goal ended, if it did.
enum class Outcome {none, succeeded, aborted, canceled};

/// A goal of an action that the logic works on.
///
/// This one, for tests without ROS, is never cancelled and sends no feedback.
template<typename Action>
class Goal
{
public:
  explicit Goal(const typename Action::Goal & goal)
  : request(goal)
  {
  }

  virtual ~Goal() = default;

  /// Return whether the work should end: the client asked for it, or sent a newer goal.
  virtual bool cancel_requested() {return false;}

  /// Send the feedback as it is now.
  virtual void publish_feedback() {}

  /// End the goal: it is reached. The result is sent when the callback returns.
  void succeed() {outcome_ = Outcome::succeeded;}

  /// End the goal: it cannot be reached.
  void abort() {outcome_ = Outcome::aborted;}

  /// End the goal because cancel_requested() said so.
  void canceled() {outcome_ = Outcome::canceled;}

  Outcome outcome() const {return outcome_;}

  const typename Action::Goal request;
  typename Action::Feedback feedback;
  typename Action::Result result;

private:
  Outcome outcome_ = Outcome::none;
};

}  // namespace contact_analysis

#endif  // CONTACT_ANALYSIS__GOAL_HPP_
