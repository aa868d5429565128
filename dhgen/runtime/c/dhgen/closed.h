/* SPDX-License-Identifier: MIT
 *
 * What the file of an arm in closed form needs. */
#ifndef DHGEN_CLOSED_H
#define DHGEN_CLOSED_H

#include "arm.h"
#include "ik.h"
#include "interface.h"
#include "lanes.h"
#include "tile.h"

#endif
