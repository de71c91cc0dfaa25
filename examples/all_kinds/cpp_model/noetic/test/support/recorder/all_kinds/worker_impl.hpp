// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef SUPPORT__RECORDER__ALL_KINDS__WORKER_IMPL_HPP_
#define SUPPORT__RECORDER__ALL_KINDS__WORKER_IMPL_HPP_

#include <mutex>
#include <string>

#include "all_kinds/worker_interface.hpp"

#include "../recorder.hpp"

namespace all_kinds
{

/// Stands in for the logic of worker: it reports what it gets, and does what the test orders.
class WorkerImpl
{
public:
  explicit WorkerImpl(const WorkerPassthrough & passthrough)
  : passthrough_(passthrough), recorder_({
      {"sleep", [this](const std::string & seconds) {
          return to_json(passthrough_.sleep(std::stod(seconds)));
        }},
      {"log", logs(passthrough.log)},
      {"fail", [this](const std::string & reason) {
          passthrough_.fail(reason + "\nfor good");
          return "null";
        }},
      {"diagnose", [status = passthrough.diagnostics](const std::string & value) {
          const auto comma = value.find(',');
          const auto level = value.substr(0, comma);
          const auto text = value.substr(comma + 1);
          status->set_hardware_id(text);
          status->set("said", text);
          if (level == "ok") {
            status->ok(text);
          } else {
            level == "error" ? status->error(text) : status->warning(text);
          }
          return "null";
        }},
      {"pub_echo", publishes(passthrough.pub_echo)},
      {"subscribers_pub_echo", counts(passthrough.pub_echo)},
      {"pub_empty", publishes(passthrough.pub_empty)},
      {"subscribers_pub_empty", counts(passthrough.pub_empty)},
      {"broadcaster_pose", broadcasts(passthrough.broadcaster_pose)},
      {"static_broadcaster_pose", broadcasts(passthrough.broadcaster_pose, true)},
      {"listener_frames", looks_up(passthrough.listener_frames)},
      {"client_permit", calls(passthrough.client_permit)},
      {"action_delegate", sends(passthrough.action_delegate)},
      {"state_action_delegate", tells(passthrough.action_delegate)},
    }, {
      publishes_each("pub_answer", passthrough.pub_answer),
    })
  {
  }

  bool configure(const WorkerConfig & config)
  {
    record(config);
    return recorder_.called("configure");
  }

  std::string reconfigure(const WorkerConfig & config)
  {
    report("reconfigure", text_of(config));
    if (!recorder_.run(recorder_.next("reconfigure"))) {
      return "told to refuse";
    }
    record(config);
    return "";
  }

  bool activate() {return recorder_.called("activate");}
  void deactivate() {recorder_.called("deactivate");}
  void cleanup() {recorder_.called("cleanup");}

  void update(WorkerData & data, const WorkerConfig & config)
  {
    recorder_.count("update", passthrough_.now().seconds());
    const auto words = recorder_.next("update");
    record(config);
    recorder_.take("in_speed", encode(data.in_speed), data.in_speed_updated);
    recorder_.take("in_counter", encode(data.in_counter), data.in_counter_updated);
    data.out_counter_active = data.out_counter_active && has(words, "out_counter=");
    data.out_status_active = data.out_status_active && has(words, "out_status=");
    recorder_.run(
      words, {
        {"out_counter", sets(data.out_counter)},
        {"subscribers_out_counter", counts(data.out_counter_subscribers)},
        {"out_status", sets(data.out_status)},
        {"subscribers_out_status", counts(data.out_status_subscribers)},
      });
  }

  void receive_say(const worker_types::SayMessage & message)
  {
    recorder_.called("receive_say", encode(message));
  }

  void receive_call(
    const std::string & topic,
    const worker_types::CallMessage & message)
  {
    recorder_.called("receive_call." + topic, encode(message));
  }

  void late_speed() {recorder_.called("late_speed");}

  void late_say() {recorder_.called("late_say");}

  void receive_sighting(const worker_types::SightingMessages & messages)
  {
    recorder_.called(
      "receive_sighting",
      "[" + encode(messages.point) +
      ", " + encode(messages.motion) + "]");
  }

  void serve_reset(
    const worker_types::ResetService::Request & request,
    worker_types::ResetService::Response & response)
  {
    recorder_.called("serve_reset", encode(request), {{"response", sets(response)}});
  }

  void serve_enable(
    const worker_types::EnableService::Request & request,
    worker_types::EnableService::Response & response)
  {
    recorder_.called("serve_enable", encode(request), {{"response", sets(response)}});
  }

  void execute_compute(Goal<worker_types::ComputeAction> & goal)
  {
    recorder_.called("execute_compute", encode(goal.request), executes(goal));
  }

  bool accept_compute(
    const worker_types::ComputeAction::Goal & request)
  {
    return recorder_.called("accept_compute", encode(request));
  }

  void execute_measure(Goal<worker_types::MeasureAction> & goal)
  {
    recorder_.called("execute_measure", encode(goal.request), executes(goal));
  }

  void read()
  {
    recorder_.take_turn("read", passthrough_.now().seconds());
    passthrough_.sleep(0.01);
  }

  void poll()
  {
    recorder_.take_turn("poll", passthrough_.now().seconds());
  }

private:
  /// Return the parameters, in JSON.
  static std::string text_of(const WorkerConfig & config)
  {
    std::string members;
    add(members, "prefix", config.prefix);
    add(members, "echo_topic", config.echo_topic);
    add(members, "call_topics", config.call_topics);
    add(members, "answer_topics", config.answer_topics);
    add(members, "weights", config.weights);
    add(members, "gain", config.gain);
    add(members, "step", config.step);
    add(members, "verbose", config.verbose);
    add(members, "label", config.label);
    return "{" + members + "}";
  }

  /// Report the parameters, if they have changed.
  void record(const WorkerConfig & config)
  {
    const auto text = text_of(config);
    const std::lock_guard<std::mutex> lock(config_mutex_);
    if (text != config_) {
      config_ = text;
      report("config", text);
    }
  }

  const WorkerPassthrough passthrough_;
  std::mutex config_mutex_;
  std::string config_;
  Recorder recorder_;
};

}  // namespace all_kinds

#endif  // SUPPORT__RECORDER__ALL_KINDS__WORKER_IMPL_HPP_
