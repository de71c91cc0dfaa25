// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef ROS__CYCLE_COUNTS_HPP_
#define ROS__CYCLE_COUNTS_HPP_

#include <atomic>
#include <cstdint>

namespace contact_analysis
{

/// How many cycles have run and how many were missed, since the start of the node.
struct CycleCounts
{
  std::atomic<std::uint64_t> run{0};
  std::atomic<std::uint64_t> missed{0};
};

}  // namespace contact_analysis

#endif  // ROS__CYCLE_COUNTS_HPP_
