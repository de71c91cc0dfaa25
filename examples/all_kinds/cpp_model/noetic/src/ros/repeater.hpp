// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__REPEATER_HPP_
#define ROS__REPEATER_HPP_

#include <functional>
#include <string>

#include "receiver.hpp"

namespace all_kinds
{

/// A thread for what the logic does again and again, until the node stops.
class Repeater : public Receiver
{
public:
  Repeater(const std::string & name, const std::function<void()> & work)
  : Receiver(name)
  {
    start(work);
  }

  ~Repeater() override {join();}

  void stop() final {}  // its waits end when the node stops
};

}  // namespace all_kinds

#endif  // ROS__REPEATER_HPP_
