// Copyright Bench
// SPDX-License-Identifier: Apache-2.0

#ifndef BENCH__RELAY_IMPL_HPP_
#define BENCH__RELAY_IMPL_HPP_

#include "bench/record.hpp"
#include "bench/relay_interface.hpp"

namespace bench
{

/// Records its cycles and the messages that they see.
class RelayImpl
{
public:
  /// Store the passthrough.
  explicit RelayImpl(
    const RelayPassthrough & passthrough);

  /// Prepare the logic; return false to reject the configuration.
  bool configure(
    const RelayConfig & config);

  /// Start operating; return false to refuse activation.
  bool activate();

  /// Compute the outputs of one cycle from the latest inputs.
  void update(
    RelayData & data,
    const RelayConfig & config);

  /// Stop everything that moves; publishers, service calls and goals still work here.
  void deactivate();

  /// Release everything created in configure.
  void cleanup();

private:
  RelayPassthrough passthrough_;
  Record record_;
};

}  // namespace bench

#endif  // BENCH__RELAY_IMPL_HPP_
