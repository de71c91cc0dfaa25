// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The logic of worker. Edit this file.

#include "all_kinds/worker_impl.hpp"

namespace all_kinds
{

WorkerImpl::WorkerImpl(
  const WorkerPassthrough & passthrough)
: passthrough_(passthrough)
{
}

bool WorkerImpl::configure(
  [[maybe_unused]] const WorkerConfig & config)
{
  return true;
}

bool WorkerImpl::activate()
{
  return true;
}

void WorkerImpl::update(
  [[maybe_unused]] WorkerData & data,
  [[maybe_unused]] const WorkerConfig & config)
{
}

std::string WorkerImpl::reconfigure(
  [[maybe_unused]] const WorkerConfig & config)
{
  return "";
}

// Topic say
void WorkerImpl::receive_say(
  [[maybe_unused]] const worker_types::SayMessage & message)
{
}

// Topic call
void WorkerImpl::receive_call(
  [[maybe_unused]] const std::string & topic,
  [[maybe_unused]] const worker_types::CallMessage & message)
{
}

// Late topic speed
void WorkerImpl::late_speed()
{
}

// Late topic say
void WorkerImpl::late_say()
{
}

// Synchronizer sighting
void WorkerImpl::receive_sighting(
  [[maybe_unused]] const worker_types::SightingMessages & messages)
{
}

// Service reset
void WorkerImpl::serve_reset(
  [[maybe_unused]] const worker_types::ResetService::Request & request,
  [[maybe_unused]] worker_types::ResetService::Response & response)
{
}

// Service enable
void WorkerImpl::serve_enable(
  [[maybe_unused]] const worker_types::EnableService::Request & request,
  [[maybe_unused]] worker_types::EnableService::Response & response)
{
}

// Action compute
void WorkerImpl::execute_compute(
  Goal<worker_types::ComputeAction> & goal)
{
  goal.succeed();
}

bool WorkerImpl::accept_compute(
  [[maybe_unused]] const worker_types::ComputeAction::Goal & request)
{
  return true;
}

// Action measure
void WorkerImpl::execute_measure(
  Goal<worker_types::MeasureAction> & goal)
{
  goal.succeed();
}

// Thread read
void WorkerImpl::read()
{
  passthrough_.sleep(1.0);
}

// Timer poll
void WorkerImpl::poll()
{
}

void WorkerImpl::deactivate()
{
}

void WorkerImpl::cleanup()
{
}

}  // namespace all_kinds
