// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Fakes of publishers, clients, goals and transforms, which record what the logic does with them.

#ifndef FAKES_HPP_
#define FAKES_HPP_

#include <memory>
#include <vector>

#include "serving/goal.hpp"

namespace serving
{

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

/// Put a fake in the place of a member of the passthrough, and return it.
template<template<typename> class Fake, template<typename> class Base, typename Type>
std::shared_ptr<Fake<Type>> fake(std::shared_ptr<Base<Type>> & member)
{
  const auto made = std::make_shared<Fake<Type>>();
  member = made;
  return made;
}

}  // namespace serving

#endif  // FAKES_HPP_
