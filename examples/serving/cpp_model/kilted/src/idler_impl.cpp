// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The logic of idler. Edit this file.

#include "serving/idler_impl.hpp"

namespace serving
{

IdlerImpl::IdlerImpl(
  const IdlerPassthrough & passthrough)
: passthrough_(passthrough)
{
}

bool IdlerImpl::configure(
  [[maybe_unused]] const IdlerConfig & config)
{
  return true;
}

bool IdlerImpl::activate()
{
  return true;
}

void IdlerImpl::deactivate()
{
}

void IdlerImpl::cleanup()
{
}

}  // namespace serving
