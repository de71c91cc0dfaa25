// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ALL_KINDS__WORKER_IMPL_HPP_
#define ALL_KINDS__WORKER_IMPL_HPP_

#include <string>

#include "all_kinds/worker_interface.hpp"

namespace all_kinds
{

/// The logic of worker.
///
/// Edit this file: worker_interface.hpp declares what the logic can use.
class WorkerImpl
{
public:
  /// Store the passthrough.
  explicit WorkerImpl(
    const WorkerPassthrough & passthrough);

  /// Prepare the logic; return false to reject the configuration.
  bool configure(
    const WorkerConfig & config);

  /// Start operating; return false to refuse activation.
  bool activate();

  /// Compute the outputs of one cycle from the latest inputs.
  void update(
    WorkerData & data,
    const WorkerConfig & config);

  /// Take changed parameters and return "", or return why they are refused.
  std::string reconfigure(
    const WorkerConfig & config);

  // Topic say
  /// Handle a message when it arrives, in a thread of its own.
  void receive_say(
    const worker_types::SayMessage & message);

  // Topic call
  /// Handle a message when it arrives, in a thread of its own.
  void receive_call(
    const std::string & topic,
    const worker_types::CallMessage & message);

  // Late topic speed
  /// Act when no message has come within the deadline, in a thread of its own.
  void late_speed();

  // Late topic say
  /// Act when no message has come within the deadline, in a thread of its own.
  void late_say();

  // Synchronizer sighting
  /// Handle messages whose stamps belong together, in a thread of its own.
  void receive_sighting(
    const worker_types::SightingMessages & messages);

  // Service reset
  /// Fill in the response, in a thread of its own.
  void serve_reset(
    const worker_types::ResetService::Request & request,
    worker_types::ResetService::Response & response);

  // Service enable
  /// Fill in the response, in a thread of its own.
  void serve_enable(
    const worker_types::EnableService::Request & request,
    worker_types::EnableService::Response & response);

  // Action compute
  /// Execute a goal and set its outcome, in a thread of its own; the stub only succeeds.
  void execute_compute(
    Goal<worker_types::ComputeAction> & goal);

  /// Return whether to accept a goal, in a thread of its own; the stub accepts all.
  bool accept_compute(
    const worker_types::ComputeAction::Goal & request);

  // Action measure
  /// Execute a goal and set its outcome, in several threads at once; the stub only succeeds.
  void execute_measure(
    Goal<worker_types::MeasureAction> & goal);

  // Thread read
  /// Do one piece of work in a thread of its own; called again, the stub once a second.
  void read();

  // Timer poll
  /// Do what is due, in a thread of its own.
  void poll();

  /// Stop everything that moves; publishers, service calls and goals still work here.
  void deactivate();

  /// Release everything created in configure.
  void cleanup();

private:
  WorkerPassthrough passthrough_;
};

}  // namespace all_kinds

#endif  // ALL_KINDS__WORKER_IMPL_HPP_
