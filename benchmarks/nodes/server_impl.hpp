// Copyright Bench
// SPDX-License-Identifier: Apache-2.0

#ifndef BENCH__SERVER_IMPL_HPP_
#define BENCH__SERVER_IMPL_HPP_

#include "bench/record.hpp"
#include "bench/server_interface.hpp"

namespace bench
{

/// Records the messages that it receives, and serves.
class ServerImpl
{
public:
  /// Store the passthrough.
  explicit ServerImpl(
    const ServerPassthrough & passthrough);

  /// Prepare the logic; return false to reject the configuration.
  bool configure(
    const ServerConfig & config);

  /// Start operating; return false to refuse activation.
  bool activate();

  // Topic values
  /// Handle a message when it arrives, in a thread of its own.
  void receive_values(
    const server_types::ValuesMessage & message);

  // Service set
  /// Fill in the response, in a thread of its own.
  void serve_set(
    const server_types::SetService::Request & request,
    server_types::SetService::Response & response);

  // Action compute
  /// Execute a goal and set its outcome, in a thread of its own; the stub only succeeds.
  void execute_compute(
    Goal<server_types::ComputeAction> & goal);

  /// Stop everything that moves; publishers, service calls and goals still work here.
  void deactivate();

  /// Release everything created in configure.
  void cleanup();

private:
  ServerPassthrough passthrough_;
  Record record_;
};

}  // namespace bench

#endif  // BENCH__SERVER_IMPL_HPP_
