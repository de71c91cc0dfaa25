#ifndef CONTRACT__BEHAVIOUR_HPP_
#define CONTRACT__BEHAVIOUR_HPP_

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <time.h>
#include <utility>
#include <vector>

namespace contract
{

// Values as JSON.
inline std::string json(bool value) {return value ? "true" : "false";}
inline std::string json(double value)
{
  std::ostringstream text;
  text << value;
  return text.str() == "inf" ? "Infinity" : text.str() == "nan" ? "NaN" : text.str();
}
inline std::string json(const std::string & value)
{
  std::string text = "\"";
  for (const char letter : value) {
    const bool is_plain = letter != '"' && letter != '\\' && letter >= ' ';
    text += is_plain ? letter : '\'';
  }
  return text + "\"";
}
inline std::string json(const char * value) {return json(std::string(value));}
template<typename Item>
std::string json(const std::vector<Item> & values)
{
  std::string text;
  for (const Item value : values) {
    text += (text.empty() ? "" : ", ") + json(value);
  }
  return "[" + text + "]";
}

/// Does what one logic object is told; see behaviour.py.
class Behaviour
{
public:
  using Arguments = std::vector<std::string>;
  using Command = std::function<std::string(const Arguments &)>;

  Behaviour(const std::string & node, const std::map<std::string, Command> & commands)
  : node_(node), commands_(commands)
  {
    const std::lock_guard<std::mutex> lock(mutex());
    static int number = 0;
    logic_ = ++number;
    commands_["block"] = [](const Arguments & arguments) {
        std::this_thread::sleep_for(std::chrono::duration<double>(std::stod(arguments.at(0))));
        return std::string("null");
      };
    commands_["hold"] = [](const Arguments &) {
        const auto before = all_told();
        while (all_told() == before) {
          std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return std::string("null");
      };
    commands_["throw"] = [](const Arguments & arguments) -> std::string {
        throw std::runtime_error(arguments.empty() ? "thrown on purpose" : arguments[0]);
      };
  }

  /// Do what a method is told; return whether it accepts.
  bool run(const std::string & method, const std::string & seen = "null") const
  {
    trace(method, "begin", seen);
    return carry_out(method, told(method));
  }

  /// Do what a place in ROS is told, which is mostly nothing and not traced then.
  void pass(const std::string & place) const
  {
    const auto commands = told(place);
    if (!commands.empty()) {
      trace(place, "begin");
      carry_out(place, commands);
    }
  }

  void trace(
    const std::string & method, const std::string & event, const std::string & value = "null") const
  {
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    std::ostringstream line;
    line << "{\"node\": " << json(node_) << ", \"logic\": " << logic_ << ", \"method\": " <<
      json(method) << ", \"event\": " << json(event) << ", \"value\": " << value <<
      ", \"thread\": " << json(thread_name()) << ", \"id\": " << syscall(SYS_gettid) <<
      ", \"time\": " << now.tv_sec << "." << std::to_string(1000000000 + now.tv_nsec).substr(1) <<
      "}\n";
    const std::string text = line.str();
    const int file = open(std::getenv("CONTRACT_TRACE"), O_WRONLY | O_APPEND | O_CREAT, 0644);
    if (write(file, text.data(), text.size()) < 0) {
      std::abort();
    }
    close(file);
  }

  static std::string thread_name()
  {
    std::ifstream comm("/proc/thread-self/comm");
    std::string name;
    std::getline(comm, name);
    return name;
  }

private:
  bool carry_out(const std::string & method, const std::vector<Arguments> & commands) const
  {
    bool accepted = true;
    try {
      for (const auto & words : commands) {
        if (words.at(0) == "refuse") {
          accepted = false;
        } else {
          const Arguments arguments(words.begin() + 1, words.end());
          const std::string value = commands_.at(words.at(0))(arguments);
          trace(method, words.at(0), value);
        }
      }
    } catch (const std::exception & error) {
      trace(method, "raised", json(error.what()));
      throw;
    }
    trace(method, "end", json(accepted));
    return accepted;
  }

  static std::mutex & mutex()
  {
    static std::mutex mutex;
    return mutex;
  }

  static std::string all_told()
  {
    std::ifstream file(std::getenv("CONTRACT_BEHAVIOUR"));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// Return the commands, as words, of a method.
  static std::vector<Arguments> told(const std::string & method)
  {
    static std::set<std::string> done;
    std::vector<Arguments> commands;
    std::ifstream file(std::getenv("CONTRACT_BEHAVIOUR"));
    for (std::string line; std::getline(file, line); ) {
      const auto colon = line.find(": ");
      const std::string when = line.substr(0, colon);
      if (when == "once " + method) {
        const std::lock_guard<std::mutex> lock(mutex());
        if (!done.insert(line).second) {
          continue;
        }
      } else if (when != method) {
        continue;
      }
      std::istringstream words(line.substr(colon + 2));
      commands.emplace_back();
      for (std::string word; words >> word; ) {
        for (std::size_t at; (at = word.find("\\n")) != std::string::npos; ) {
          word.replace(at, 2, "\n");
        }
        commands.back().push_back(word);
      }
    }
    return commands;
  }

  std::string node_;
  int logic_ = 0;
  std::map<std::string, Command> commands_;
};

}  // namespace contract

#endif  // CONTRACT__BEHAVIOUR_HPP_
