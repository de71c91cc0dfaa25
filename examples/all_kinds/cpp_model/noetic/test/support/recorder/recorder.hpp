// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// What logics that obey the test have in common.
//
// A line of stdin, METHOD STEP=VALUE STEP..., says what to do when a method is called next; `now`,
// at once. Calls and the results of steps are reported to stdout: name and value, in JSON. Messages
// are serialized, in hexadecimal. Without an order nothing is published.

#ifndef SUPPORT__RECORDER__RECORDER_HPP_
#define SUPPORT__RECORDER__RECORDER_HPP_

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "all_kinds/ros/action_client.hpp"
#include "all_kinds/ros/goal.hpp"
#include "all_kinds/ros/logger.hpp"
#include "all_kinds/ros/publisher.hpp"
#include "all_kinds/ros/service_client.hpp"
#include "all_kinds/ros/time.hpp"
#include "ros/serialization.h"

namespace all_kinds
{

/// Write a line for the test, in one call, as other threads write too.
inline void report(const std::string & name, const std::string & json)
{
  std::cout << "report [\"" + name + "\", " + json + "]\n" << std::flush;
}

inline std::string to_json(bool value) {return value ? "true" : "false";}

template<typename Value>
std::string to_json(const Value & value)
{
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

inline std::string to_json(const std::string & value)
{
  std::string text = "\"";
  for (const char letter : value) {
    if (letter == '"' || letter == '\\') {
      text += '\\';
    }
    text += letter == '\n' ? "\\n" : std::string(1, letter);
  }
  return text + '"';
}

inline std::string to_json(const char * value) {return to_json(std::string(value));}

template<typename Value>
std::string to_json(const std::vector<Value> & values)
{
  std::string text;
  for (const Value & value : values) {
    text += (text.empty() ? "" : ", ") + to_json(value);
  }
  return "[" + text + "]";
}

/// Add a value to the members of an object in JSON.
template<typename Value>
void add(std::string & members, const std::string & name, const Value & value)
{
  members += (members.empty() ? "" : ", ") + to_json(name) + ": " + to_json(value);
}

/// Return a serialized message as a JSON string of hexadecimal digits.
template<typename Message>
std::string encode(const Message & message)
{
  const auto raw = ros::serialization::serializeMessage(message);
  const std::vector<std::uint8_t> bytes(raw.buf.get(), raw.buf.get() + raw.num_bytes);
  std::ostringstream text;
  text << std::hex << std::setfill('0');
  for (const int byte : bytes) {
    text << std::setw(2) << byte;
  }
  return to_json(text.str());
}

/// Return a message from hexadecimal.
template<typename Message>
Message decode(const std::string & text)
{
  std::vector<std::uint8_t> bytes;
  for (std::size_t at = 0; at < text.size(); at += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(at, 2), nullptr, 16)));
  }
  Message message;
  bytes.erase(bytes.begin(), bytes.begin() + 4);  // the length
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(stream, message);
  return message;
}

/// What a step does with its value; the result is JSON.
using Step = std::function<std::string(const std::string &)>;
using Steps = std::map<std::string, Step>;
using Words = std::vector<std::string>;

/// Return whether some words order a step.
inline bool has(const Words & words, const std::string & step)
{
  return std::any_of(
    words.begin(), words.end(), [&](const auto & word) {return word.rfind(step, 0) == 0;});
}

/// Obeys the orders of the test.
class Recorder
{
public:
  explicit Recorder(Steps steps, const std::vector<Steps> & more = {})
  {
    for (const auto & each : more) {
      steps.insert(each.begin(), each.end());
    }
    steps["raise"] = [](const auto & what) -> std::string {
        if (what == "other") {  // no std::exception
          throw what;
        }
        throw std::runtime_error("told to raise");
      };
    steps["turns"] = [](const auto & method) {
        const std::lock_guard<std::mutex> lock(shared().mutex);
        const auto & [count, times] = shared().turns[method];
        return "[" + to_json(count) + ", " + (count ? times : "0, 0") + "]";
      };
    steps["wait"] = [](const auto & seconds) {
        std::this_thread::sleep_for(std::chrono::duration<double>(std::stod(seconds)));
        return "null";
      };
    steps["block"] = [](const auto &) {
        std::unique_lock<std::mutex> lock(shared().mutex);
        const int before = shared().releases;
        shared().released.wait(lock, [before] {return shared().releases != before;});
        return thread();
      };
    steps["release"] = [](const auto &) {
        const std::lock_guard<std::mutex> lock(shared().mutex);
        ++shared().releases;
        shared().released.notify_all();
        return "null";
      };
    steps_ = std::make_shared<Steps>(std::move(steps));
    shared().steps = steps_;
    if (!shared().is_listening) {
      shared().is_listening = true;
      listen("");
      std::thread([] {listen("\n");}).detach();
    }
  }

  /// Report a call with the name of its thread, and obey; return false where it is to refuse.
  bool called(const std::string & method) {return called(method, thread());}

  /// Report a call of a method, and obey; return false where it is to refuse.
  bool called(const std::string & method, const std::string & call, const Steps & own = {})
  {
    const auto words =
      next(method);  // before the report, after which the test may order the next call
    report(method, call);
    return run(words, own);
  }

  /// Count a call of update, of a thread or of a timer, with wall and ROS time.
  void count(const std::string & method, double now)
  {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now().time_since_epoch();
    const std::lock_guard<std::mutex> lock(shared().mutex);
    auto & [count, times] = shared().turns[method];
    ++count;
    times = to_json(wall.count()) + ", " + to_json(now);
  }

  /// Count a call of a thread or timer; report it and obey, if something was ordered.
  void take_turn(const std::string & method, double now)
  {
    count(method, now);
    {
      const std::lock_guard<std::mutex> lock(shared().mutex);
      if (shared().orders[method].empty()) {
        return;
      }
    }
    called(method);
  }

  /// Report a message that is new, or not that of the cycle before.
  void take(const std::string & name, const std::string & message, bool is_new)
  {
    const auto last = taken_.try_emplace(name, message).first;
    if (is_new || last->second != message) {
      report(name, message);
    }
    last->second = message;
  }

  /// Return what was ordered for a call of a method.
  Words next(const std::string & method)
  {
    const std::lock_guard<std::mutex> lock(shared().mutex);
    auto & orders = shared().orders[method];
    Words words;
    if (!orders.empty()) {
      words = orders.front();
      orders.pop_front();
    }
    return words;
  }

  /// Do what was ordered; return false where a method is to refuse.
  bool run(const Words & words, const Steps & own = {}) {return run(words, own, *steps_);}

private:
  struct Shared
  {
    std::ifstream input{"/dev/stdin"};  // not std::cin: exit() would wait for the thread that reads
    std::mutex mutex;
    std::map<std::string, std::deque<Words>> orders;
    // How often each method was called; wall and ROS time of the last call
    std::map<std::string, std::pair<int, std::string>> turns;
    std::weak_ptr<Steps> steps;  // they keep publishers and clients
    bool is_listening = false;
    std::condition_variable released;
    int releases = 0;
  };

  /// Return the name of the calling thread.
  static std::string thread()
  {
    std::ifstream file("/proc/thread-self/comm");
    std::string name;
    std::getline(file, name);
    return to_json(name);
  }

  static Shared & shared()
  {
    static Shared & shared = *new Shared;  // never destroyed, as a thread reads on at the end
    return shared;
  }

  static bool run(const Words & words, const Steps & own, const Steps & steps)
  {
    for (const auto & word : words) {
      const auto name = word.substr(0, word.find('='));
      if (name == "refuse") {
        return false;
      }
      report("begun", to_json(name));
      const auto & step = own.count(name) ? own.at(name) : steps.at(name);
      report(name, step(name == word ? "" : word.substr(name.size() + 1)));
    }
    return true;
  }

  /// Take orders until a certain line.
  static void listen(const std::string & last)
  {
    std::string line;
    while (std::getline(shared().input, line) && line != last) {
      std::istringstream rest(line);
      std::string method;
      rest >> method;
      const Words words{std::istream_iterator<std::string>(rest), {}};
      if (method == "now") {
        if (const auto steps = shared().steps.lock()) {
          run(words, {}, *steps);
        }
        continue;
      }
      const std::lock_guard<std::mutex> lock(shared().mutex);
      shared().orders[method].push_back(words);
      report("order", "null");
    }
  }

  std::shared_ptr<Steps> steps_;
  std::map<std::string, std::string> taken_;
};

/// The step that writes to the log in each way.
inline Step logs(const Logger & log)
{
  return [log](const auto &) {
           log.debug("said as debug");
           log.info("said as info");
           log.warning("said as warning");
           log.error("said as error");
           log.debug_once("said once");
           log.info_once("said once");
           log.error_once("said once");
           log.warning_throttle(1e3, "said once");
           return "null";
         };
}

/// The step that sets a message.
template<typename Message>
Step sets(Message & message)
{
  return [&message](const std::string & text) {
           message = decode<Message>(text);
           return "null";
         };
}

/// Split a text at its commas.
inline Words split(const std::string & text)
{
  Words words;
  std::istringstream rest(text);
  for (std::string word; std::getline(rest, word, ','); ) {
    words.push_back(word);
  }
  return words;
}

/// The step that tells how many subscribe.
inline Step counts(std::size_t subscribers)
{
  return [subscribers](const std::string &) {return to_json(subscribers);};
}

/// The step that asks how many subscribe.
template<typename Message>
Step counts(const std::shared_ptr<Publisher<Message>> & publisher)
{
  return [publisher](const std::string &) {return to_json(publisher->subscriber_count());};
}

/// The step that publishes a message.
template<typename Message>
Step publishes(const std::shared_ptr<Publisher<Message>> & publisher)
{
  return [publisher](const std::string & text) {
           publisher->publish(decode<Message>(text));
           return "null";
         };
}

/// The steps of the publishers of a list of topics: NAME.TOPIC.
template<typename Message>
Steps publishes_each(
  const std::string & name,
  const std::map<std::string, std::shared_ptr<Publisher<Message>>> & publishers)
{
  Steps steps;
  for (const auto & [topic, publisher] : publishers) {
    steps[name + "." + topic] = publishes(publisher);
    steps["subscribers_" + name + "." + topic] = counts(publisher);
  }
  return steps;
}

/// The step that broadcasts a transform: PARENT,CHILD,X.
template<typename Broadcaster>
Step broadcasts(const std::shared_ptr<Broadcaster> & broadcaster, bool is_static = false)
{
  return [broadcaster, is_static](const std::string & text) {
           const auto words = split(text);
           const typename Broadcaster::Translation along{std::stod(words[2]), 1.0, 2.0};
           const typename Broadcaster::Rotation around{0.0, 0.6, 0.8, 0.0};
           is_static ? broadcaster->broadcast_static(words[0], words[1], along, around) :
           broadcaster->broadcast(words[0], words[1], along, around);
           return "null";
         };
}

/// The step that looks up a transform along x, or says why not: TARGET,SOURCE, and TIMEOUT,STAMP.
template<typename Listener>
Step looks_up(const std::shared_ptr<Listener> & listener)
{
  return [listener](const std::string & text) {
           const auto words = split(text);
           const bool waits = words.size() > 2;
           const std::chrono::duration<double> timeout(waits ? std::stod(words[2]) : 0.0);
           const Time stamp(words.size() > 3 ? std::stoll(words[3]) * 1'000'000'000 : 0);
           const auto found = waits ? listener->lookup(words[0], words[1], timeout, stamp) :
             listener->lookup(words[0], words[1]);
           const auto reason = listener->reason();
           return reason.empty() ? to_json(found->transform.translation.x) : to_json(reason);
         };
}

/// The step that calls a service: REQUEST or REQUEST,TIMEOUT.
template<typename Service>
Step calls(const std::shared_ptr<ServiceClient<Service>> & client)
{
  return [client](const std::string & text) {
           const auto comma = text.find(',');
           const auto request = decode<typename Service::Request>(text.substr(0, comma));
           using Timeout = std::chrono::duration<double>;
           const auto response = comma == std::string::npos ? client->call(request) :
             client->call(request, Timeout(std::stod(text.substr(comma + 1))));
           return response ? encode(*response) : "null";
         };
}

/// The steps of a callback that executes a goal.
template<typename Action>
Steps executes(Goal<Action> & goal)
{
  return {
    {"result", sets(goal.result)},
    {"feedback", [&goal](const std::string & text) {
        goal.feedback = decode<typename Action::Feedback>(text);
        goal.publish_feedback();
        return "null";
      }},
    {"await", [&goal](const std::string &) {
        while (!goal.cancel_requested()) {
          std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return "null";
      }},
    {"end", [&goal](const std::string & outcome) {
        outcome == "succeed" ? goal.succeed() : outcome == "abort" ? goal.abort() : goal.canceled();
        return "null";
      }},
  };
}

/// The step that sends a goal, or cancels it where there is none.
template<typename Action>
Step sends(const std::shared_ptr<ActionClient<Action>> & client)
{
  return [client](const std::string & text) -> std::string {
           if (!text.empty()) {
             return to_json(client->send_goal(decode<typename Action::Goal>(text)));
           }
           client->cancel();
           return "null";
         };
}

/// The step that tells state, feedback and result of a goal.
template<typename Action>
Step tells(const std::shared_ptr<ActionClient<Action>> & client)
{
  return [client](const std::string &) {
           const auto state = to_json(to_string(client->state()));
           const auto feedback = client->feedback();
           const auto result = client->result();
           return "[" + state + ", " + (feedback ? encode(*feedback) : "null") + ", " +
                  (result ? encode(*result) : "null") + "]";
         };
}

}  // namespace all_kinds

#endif  // SUPPORT__RECORDER__RECORDER_HPP_
