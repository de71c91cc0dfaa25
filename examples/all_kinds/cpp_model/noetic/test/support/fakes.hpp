// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Fakes of what the logic is given, which record what it does with them.

#ifndef SUPPORT__FAKES_HPP_
#define SUPPORT__FAKES_HPP_

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "all_kinds/ros/action_client.hpp"
#include "all_kinds/ros/goal.hpp"
#include "all_kinds/ros/publisher.hpp"
#include "all_kinds/ros/service_client.hpp"
#include "all_kinds/ros/time.hpp"
#include "all_kinds/ros/transforms.hpp"

namespace all_kinds
{

/// Records messages; the test sets how many `subscribers` there are.
template<typename Message>
class FakePublisher : public Publisher<Message>
{
public:
  void publish(const Message & message) override {published.push_back(message);}
  std::size_t subscriber_count() override {return subscribers;}

  std::size_t subscribers = 0;
  std::vector<Message> published;
};

/// Records requests, and answers each with `response`; without one there is no server.
template<typename Service>
class FakeServiceClient : public ServiceClient<Service>
{
public:
  bool is_ready() override {return response.has_value();}

  std::vector<typename Service::Request> requests;
  std::optional<typename Service::Response> response;

protected:
  std::optional<typename Service::Response> wait_for_response(
    const typename Service::Request & request,
    typename ServiceClient<Service>::Seconds /* timeout */) override
  {
    requests.push_back(request);
    return response;
  }
};

/// Records goals; the test says whether there is a server, and what becomes of the goal.
template<typename Action>
class FakeActionClient : public ActionClient<Action>
{
public:
  bool is_ready() override {return ready;}

  bool send_goal(const typename Action::Goal & goal) override
  {
    goals.push_back(goal);
    goal_feedback.reset();
    goal_result.reset();
    goal_state = ready ? ActionState::pending : ActionState::lost;
    return ready;
  }

  void cancel() override {++cancels;}
  ActionState state() override {return goal_state;}
  std::shared_ptr<const typename Action::Feedback> feedback() override {return goal_feedback;}
  std::shared_ptr<const typename Action::Result> result() override {return goal_result;}

  bool ready = true;
  std::vector<typename Action::Goal> goals;
  int cancels = 0;
  ActionState goal_state = ActionState::idle;
  std::shared_ptr<typename Action::Feedback> goal_feedback;
  std::shared_ptr<typename Action::Result> goal_result;
};

/// A goal for execute_<action>; `published` is the feedback.
template<typename Action>
class FakeGoal : public Goal<Action>
{
public:
  using Goal<Action>::Goal;

  bool cancel_requested() override {return cancel;}
  void publish_feedback() override {published.push_back(this->feedback);}

  bool cancel = false;
  std::vector<typename Action::Feedback> published;
};

/// Finds what the test puts into `transforms`, by pairs of target and source.
template<typename Transform>
class FakeTransformListener : public TransformListener<Transform>
{
public:
  std::map<std::pair<std::string, std::string>, Transform> transforms;

protected:
  std::optional<Transform> wait_for_transform(
    const std::string & target,
    const std::string & source,
    typename TransformListener<Transform>::Seconds /* timeout */,
    Time /* stamp */,
    std::string & reason) override
  {
    const auto found = transforms.find({target, source});
    if (found != transforms.end()) {
      return found->second;
    }
    reason = "There is no transform from " + source + " to " + target + ".";
    return std::nullopt;
  }
};

/// Records transforms.
template<typename Transform>
class FakeTransformBroadcaster : public TransformBroadcaster<Transform>
{
public:
  void send(const Transform & transform) override {sent.push_back(transform);}
  void send_static(const Transform & transform) override {sent_static.push_back(transform);}

  std::vector<Transform> sent;
  std::vector<Transform> sent_static;
};

/// Put a fake in the place of a member of the passthrough, and return it.
template<template<typename> class Fake, template<typename> class Base, typename Type>
std::shared_ptr<Fake<Type>> fake(std::shared_ptr<Base<Type>> & member)
{
  const auto made = std::make_shared<Fake<Type>>();
  member = made;
  return made;
}

/// Put fakes in the place of the publishers of a list of topics, and return them.
template<typename Message>
std::map<std::string, std::shared_ptr<FakePublisher<Message>>> fake_each(
  std::map<std::string, std::shared_ptr<Publisher<Message>>> & members,
  const std::vector<std::string> & topics)
{
  std::map<std::string, std::shared_ptr<FakePublisher<Message>>> made;
  for (const auto & topic : topics) {
    made[topic] = fake<FakePublisher>(members[topic]);
  }
  return made;
}

}  // namespace all_kinds

#endif  // SUPPORT__FAKES_HPP_
