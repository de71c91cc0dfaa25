#pragma once

struct Filter
{
  double gain = 1.0;
  double step(double value) {return gain * value;}
};
