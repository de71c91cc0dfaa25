// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__WORKER_IMPL_HPP_
#define ALL_KINDS__WORKER_IMPL_HPP_

#include "all_kinds/worker_interface.hpp"

namespace all_kinds
{

/// The logic of worker.
///
/// This file is yours: worker_interface.hpp says what the logic can use.
/// ROS calls each callback in a thread of its own: guard with a mutex what they share.
class WorkerImpl
{
public:
  /// Keep what the logic may use at any time.
  explicit WorkerImpl(
    const WorkerPassthrough & passthrough);

  /// Prepare for work; return false to refuse the configuration.
  bool configure(
    const WorkerConfig & config);

  /// Turn the latest inputs into outputs, once in every cycle.
  void update(
    WorkerData & data,
    const WorkerConfig & config);

  // Topic say
  /// Handle a message at once.
  void receive_say(
    const worker_types::SayMessage & message);

  // Service reset
  /// Fill in the response to a request.
  void serve_reset(
    const worker_types::ResetService::Request & request,
    worker_types::ResetService::Response & response);

  // Service enable
  /// Fill in the response to a request.
  void serve_enable(
    const worker_types::EnableService::Request & request,
    worker_types::EnableService::Response & response);

  // Action compute
  /// Work on a goal until it succeeds, is aborted, or its cancelling is requested.
  void execute_compute(
    Goal<worker_types::ComputeAction> & goal);

  // End of life
  /// Let go of what configure took.
  void cleanup();

private:
  WorkerPassthrough passthrough_;
};

}  // namespace all_kinds

#endif  // ALL_KINDS__WORKER_IMPL_HPP_
