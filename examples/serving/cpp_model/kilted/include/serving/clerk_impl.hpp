// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef SERVING__CLERK_IMPL_HPP_
#define SERVING__CLERK_IMPL_HPP_

#include "serving/clerk_interface.hpp"

namespace serving
{

/// The logic of clerk.
///
/// This file is yours: clerk_interface.hpp says what the logic can use.
/// ROS calls each callback in a thread of its own: guard with a mutex what they share.
class ClerkImpl
{
public:
  /// Keep what the logic may use at any time.
  explicit ClerkImpl(
    const ClerkPassthrough & passthrough);

  /// Prepare for work; return false to refuse the configuration.
  bool configure(
    const ClerkConfig & config);

  // Service greet
  /// Fill in the response to a request.
  void serve_greet(
    const clerk_types::GreetService::Request & request,
    clerk_types::GreetService::Response & response);

  // Service ~/open
  /// Fill in the response to a request.
  void serve_open(
    const clerk_types::OpenService::Request & request,
    clerk_types::OpenService::Response & response);

  // Action count
  /// Work on a goal until it succeeds, is aborted, or its cancelling is requested.
  void execute_count(
    Goal<clerk_types::CountAction> & goal);

  // End of life
  /// Let go of what configure took.
  void cleanup();

private:
  ClerkPassthrough passthrough_;
};

}  // namespace serving

#endif  // SERVING__CLERK_IMPL_HPP_
