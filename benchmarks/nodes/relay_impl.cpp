// Copyright Bench
// SPDX-License-Identifier: Apache-2.0

// The logic of relay.

#include "bench/relay_impl.hpp"

namespace bench
{

RelayImpl::RelayImpl(
  const RelayPassthrough & passthrough)
: passthrough_(passthrough)
{
}

bool RelayImpl::configure(
  [[maybe_unused]] const RelayConfig & config)
{
  return true;
}

bool RelayImpl::activate()
{
  return true;
}

void RelayImpl::update(
  RelayData & data,
  [[maybe_unused]] const RelayConfig & config)
{
  if (data.in_values_updated) {
    record_.message(data.in_values.data.at(0));
  }
  data.out_tick.data = record_.cycle();
}

void RelayImpl::deactivate()
{
  record_.save();
}

void RelayImpl::cleanup()
{
}

}  // namespace bench
