// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__CYCLE_COUNTS_HPP_
#define ROS__CYCLE_COUNTS_HPP_

#include <atomic>
#include <cstdint>

namespace driving
{

/// How many cycles have run and how many were missed, since the start of the node.
struct CycleCounts
{
  std::atomic<std::uint64_t> run{0};
  std::atomic<std::uint64_t> missed{0};
};

}  // namespace driving

#endif  // ROS__CYCLE_COUNTS_HPP_
