// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// The logic of contact_evaluate. Edit this file.

#include "contact_analysis/contact_evaluate_impl.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace contact_analysis
{

namespace
{

using contact_evaluate_types::InCop;
using contact_evaluate_types::PubPlotLearnCop;

const char FILE_NAME[] = "contacts.txt";  // a contact a line: means, standard deviations, name
const double LIMIT = 3.0;  // how far from the mean a contact reaches, in standard deviations
const double RESOLUTION = 0.001;  // of the sensor, in m
const double PERIOD = 0.01;  // in which goals look at what was measured, in s
const std::size_t BUFFER = 1000;  // how many centers of pressure to keep for a goal

std::array<double, 3> coordinates(const InCop & cop)
{
  return {cop.x, cop.y, cop.z};
}

/// Return the name and the contact of a line; throw std::invalid_argument if it has none.
std::pair<std::string, Contact> read(const std::string & line)
{
  std::istringstream text(line);
  std::pair<std::string, Contact> named;
  auto & [name, contact] = named;
  bool valid = true;
  for (double & value : contact.mean) {
    text >> value;
  }
  for (double & value : contact.deviation) {
    text >> value;
    valid = valid && value > 0.0;
  }
  if (!valid || text.get() != ' ' || !std::getline(text, name) || name.empty()) {
    throw std::invalid_argument("six finite numbers and a name are expected");
  }
  return named;
}

}  // namespace

Contact Contact::learn(const Cops & cops)
{
  const auto count = static_cast<double>(cops.size());
  Contact contact;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const auto & cop : cops) {
      contact.mean[axis] += coordinates(cop)[axis] / count;
    }
    double variance = 0.0;
    for (const auto & cop : cops) {
      variance += std::pow(coordinates(cop)[axis] - contact.mean[axis], 2) / count;
    }
    contact.deviation[axis] = std::max(std::sqrt(variance), RESOLUTION);
  }
  return contact;
}

double Contact::distance(const InCop & cop) const
{
  std::array<double, 3> distances;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    distances[axis] = (coordinates(cop)[axis] - mean[axis]) / deviation[axis];
  }
  return std::hypot(distances[0], distances[1], distances[2]);
}

ContactEvaluateImpl::ContactEvaluateImpl(
  const ContactEvaluatePassthrough & passthrough)
: passthrough_(passthrough)
{
}

bool ContactEvaluateImpl::configure(
  const ContactEvaluateConfig & config)
{
  if (config.samples < 1) {
    passthrough_.log.error("samples must be at least 1");
    return false;
  }
  samples_ = static_cast<std::size_t>(config.samples);
  return true;
}

bool ContactEvaluateImpl::activate()
{
  return true;
}

void ContactEvaluateImpl::update(
  ContactEvaluateData & data,
  const ContactEvaluateConfig & config)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  plots_ = config.pub_sample;
  if (data.in_cop_updated) {
    for (auto * buffer : {&to_learn_, &to_evaluate_}) {
      buffer->push_back(data.in_cop);
      if (buffer->size() > BUFFER) {
        buffer->pop_front();
      }
    }
  }
}

// Service load
void ContactEvaluateImpl::serve_load(
  const contact_evaluate_types::LoadService::Request & request,
  contact_evaluate_types::LoadService::Response & response)
{
  std::ifstream file(request.data + "/" + FILE_NAME);
  Contacts contacts;
  try {
    if (!file) {
      throw std::invalid_argument(std::strerror(errno));
    }
    for (std::string line; std::getline(file, line); ) {
      contacts.insert(read(line));
    }
  } catch (const std::invalid_argument & error) {
    response.message = std::string(FILE_NAME) + " cannot be loaded: " + error.what();
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  contacts_ = contacts;
  response.success = true;
}

// Service store
void ContactEvaluateImpl::serve_store(
  const contact_evaluate_types::StoreService::Request & request,
  contact_evaluate_types::StoreService::Response & response)
{
  std::ofstream file(request.data + "/" + FILE_NAME);
  file.precision(std::numeric_limits<double>::max_digits10);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto & [name, contact] : contacts_) {
      for (const auto & values : {contact.mean, contact.deviation}) {
        for (const double value : values) {
          file << value << ' ';
        }
      }
      file << name << '\n';
    }
  }
  file.close();
  response.success = file.good();
  if (!file) {
    response.message = std::string(FILE_NAME) + " cannot be stored: " + std::strerror(errno);
  }
}

// Action learn
void ContactEvaluateImpl::execute_learn(
  Goal<contact_evaluate_types::LearnAction> & goal)
{
  const std::string name = goal.request.contact;
  if (name.empty() || name.find('\n') != std::string::npos) {
    passthrough_.log.error("a contact needs a name, in one line");
    goal.abort();
    return;
  }
  PubPlotLearnCop learned;
  take(to_learn_);  // leaves out what was measured before
  while (learned.points.size() < samples_) {
    passthrough_.sleep(PERIOD);
    if (goal.cancel_requested()) {
      goal.canceled();
      return;
    }
    for (const auto & cop : take(to_learn_)) {
      if (learned.points.size() < samples_) {
        learned.points.push_back(cop);
      }
    }
    const auto count = static_cast<double>(learned.points.size());
    goal.feedback.progress = count / static_cast<double>(samples_);
    goal.publish_feedback();
  }
  bool plots;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    contacts_[name] = Contact::learn(learned.points);
    plots = plots_;
  }
  if (plots) {
    passthrough_.pub_plot_learn_cop->publish(learned);
  }
  goal.result.samples = static_cast<decltype(goal.result.samples)>(samples_);
  goal.succeed();
}

// Action evaluate
void ContactEvaluateImpl::execute_evaluate(
  Goal<contact_evaluate_types::EvaluateAction> & goal)
{
  using Request = contact_evaluate_types::EvaluateAction::Goal;
  const bool is_limited = goal.request.duration != Request::UNTIL_CANCELED;
  const double end = passthrough_.now().seconds() + goal.request.duration;
  std::map<std::string, int> found;
  take(to_evaluate_);  // leaves out what was measured before
  while (!goal.cancel_requested() && !(is_limited && passthrough_.now().seconds() >= end)) {
    passthrough_.sleep(PERIOD);
    const auto cops = take(to_evaluate_);
    for (const auto & cop : cops) {
      ++found[contact_of(cop)];
    }
    if (!cops.empty()) {
      goal.feedback.cop = cops.back();
      goal.publish_feedback();
    }
  }
  int most = 0;
  for (const auto & [name, count] : found) {
    if (count > most) {
      goal.result.contact = name;
      most = count;
    }
  }
  if (goal.cancel_requested()) {
    goal.canceled();
  } else {
    goal.succeed();
  }
}

void ContactEvaluateImpl::deactivate()
{
}

void ContactEvaluateImpl::cleanup()
{
}

Cops ContactEvaluateImpl::take(Buffer & buffer)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const Cops taken(buffer.begin(), buffer.end());
  buffer.clear();
  return taken;
}

std::string ContactEvaluateImpl::contact_of(const InCop & cop)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  std::string nearest;
  double smallest = LIMIT;
  for (const auto & [name, contact] : contacts_) {
    const double distance = contact.distance(cop);
    if (distance <= smallest) {
      nearest = name;
      smallest = distance;
    }
  }
  return nearest;
}

}  // namespace contact_analysis
