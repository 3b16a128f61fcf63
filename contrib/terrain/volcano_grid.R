#!/usr/bin/env Rscript
# SPDX-License-Identifier: GPL-3.0-or-later
# Write the elevations of Maunga Whau (Mt Eden), a volcano in Auckland, as an ESRI ASCII grid: 'volcano' of R's datasets
# (Debian's r-base-core), digitised by Ross Ihaka from a topographic map, 61 x 87 points 10 m apart, in whole metres.
#
#   Rscript contrib/terrain/volcano_grid.R prm/landslide/maunga_whau.asc
#
# Its rows are lines from east to west, the first the southernmost one; the grid's rows are from west to east, the first the
# northernmost one. The origin of the coordinates, m, is the south-western point.
file <- file(commandArgs(trailingOnly = TRUE)[1], "w")
volcano <- datasets::volcano
cat(sprintf("ncols %d\nnrows %d\nxllcenter 0\nyllcenter 0\ncellsize 10\nNODATA_value -9999\n", ncol(volcano), nrow(volcano)),
    file = file, sep = "")
for (row in nrow(volcano):1) cat(paste(rev(volcano[row, ]), collapse = " "), "\n", file = file, sep = "")
close(file)
