// Orders what the next call does as soon as a call is reported, as a test can; prints what it did.

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <streambuf>
#include <string>

#include "recorder.hpp"

/// Stands for standard output.
class Orders : public std::streambuf
{
public:
  explicit Orders(int input)
  : input_(input)
  {
    dprintf(input, "\n");  // no order before the logic is made
  }

private:
  std::streamsize xsputn(const char * text, std::streamsize size) override
  {
    const std::string line(text, size);
    if (line.find("\"order\"") != std::string::npos) {
      is_ordered_ = true;
    } else if (line.find("\"activate\"") != std::string::npos) {
      is_ordered_ = false;
      dprintf(input_, "activate refuse\n");
      while (!is_ordered_) {
        usleep(1000);
      }
    }
    return size;
  }

  const int input_;
  std::atomic<bool> is_ordered_{false};
};

int main()
{
  int ends[2];
  if (pipe(ends) != 0 || dup2(ends[0], STDIN_FILENO) < 0) {
    return 1;
  }
  Orders orders(ends[1]);
  std::cout.rdbuf(&orders);
  mypkg::Recorder recorder({});
  const bool first = recorder.called("activate");
  const bool second = recorder.called("activate");
  printf("%d %d\n", first, second);
  fflush(stdout);
  _exit(0);  // the thread that reads orders is still there
}
