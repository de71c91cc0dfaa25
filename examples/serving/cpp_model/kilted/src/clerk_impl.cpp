// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The logic of clerk. Edit this file.

#include "serving/clerk_impl.hpp"

namespace serving
{

ClerkImpl::ClerkImpl(
  const ClerkPassthrough & passthrough)
: passthrough_(passthrough)
{
}

bool ClerkImpl::configure(
  [[maybe_unused]] const ClerkConfig & config)
{
  return true;
}

bool ClerkImpl::activate()
{
  return true;
}

// Service greet
void ClerkImpl::serve_greet(
  [[maybe_unused]] const clerk_types::GreetService::Request & request,
  [[maybe_unused]] clerk_types::GreetService::Response & response)
{
}

// Service ~/open
void ClerkImpl::serve_open(
  [[maybe_unused]] const clerk_types::OpenService::Request & request,
  [[maybe_unused]] clerk_types::OpenService::Response & response)
{
}

// Action count
void ClerkImpl::execute_count(
  Goal<clerk_types::CountAction> & goal)
{
  goal.succeed();
}

void ClerkImpl::deactivate()
{
}

void ClerkImpl::cleanup()
{
}

}  // namespace serving
