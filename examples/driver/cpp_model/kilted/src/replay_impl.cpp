// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The logic of replay. Edit this file.

#include "driver/replay_impl.hpp"

namespace driver
{

ReplayImpl::ReplayImpl(
  const ReplayPassthrough & passthrough)
: passthrough_(passthrough)
{
}

bool ReplayImpl::configure(
  [[maybe_unused]] const ReplayConfig & config)
{
  return true;
}

bool ReplayImpl::activate()
{
  return true;
}

// Timer play
void ReplayImpl::play()
{
}

void ReplayImpl::deactivate()
{
}

void ReplayImpl::cleanup()
{
}

}  // namespace driver
