// What a measured node does with its time, for the program that measures it.

#ifndef BENCH__RECORD_HPP_
#define BENCH__RECORD_HPP_

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <utility>
#include <vector>

namespace bench
{

/// Keeps when cycles ran, and when messages were sent and came, until they are saved.
class Record
{
public:
  /// Record a cycle; return the time.
  double cycle()
  {
    cycles_.push_back(now());
    return cycles_.back();
  }

  /// Record a message.
  void message(double sent)
  {
    messages_.emplace_back(sent, now());
  }

  /// Write all times, one a line: of cycles, then of messages.
  void save() const
  {
    std::ofstream file(std::getenv("BENCH_RECORD"));
    file << std::fixed << std::setprecision(9);
    for (const double time : cycles_) {
      file << "cycle " << time << "\n";
    }
    for (const auto & [sent, came] : messages_) {
      file << "message " << sent << "\nmessage " << came << "\n";
    }
  }

private:
  static double now()
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
           .count();
  }

  std::vector<double> cycles_;
  std::vector<std::pair<double, double>> messages_;
};

}  // namespace bench

#endif  // BENCH__RECORD_HPP_
