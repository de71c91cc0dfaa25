// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The logic of observer. Edit this file.

#include "all_kinds/observer_impl.hpp"

namespace all_kinds
{

ObserverImpl::ObserverImpl(
  const ObserverPassthrough & passthrough)
: passthrough_(passthrough)
{
}

bool ObserverImpl::configure(
  [[maybe_unused]] const ObserverConfig & config)
{
  return true;
}

bool ObserverImpl::activate()
{
  return true;
}

void ObserverImpl::update(
  [[maybe_unused]] ObserverData & data,
  [[maybe_unused]] const ObserverConfig & config)
{
}

// Synchronizer pair
void ObserverImpl::receive_pair(
  [[maybe_unused]] const observer_types::PairMessages & messages)
{
}

void ObserverImpl::deactivate()
{
}

void ObserverImpl::cleanup()
{
}

}  // namespace all_kinds
