#!/usr/bin/env Rscript
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Computes every number of a study's report again, in R and from the exported CSV alone, and compares.
#   Rscript scripts/study_report.R EXPORT_FOLDER STUDY FIGURES/numbers.csv [OUT.csv: what R found]
# EXPORT_FOLDER: of `placodectl export csv --study STUDY`; numbers.csv: of `placodectl report study`.
# Base R only. Ends with status 1 and a list when a number differs by more than 1e-6 of itself.
arguments <- commandArgs(trailingOnly = TRUE)
if (!length(arguments) %in% 3:4) stop("usage: study_report.R EXPORT_FOLDER STUDY numbers.csv")
folder <- arguments[1]; study <- arguments[2]
expected <- read.csv(arguments[3], colClasses = c("character", "character", "character", "numeric"))
codebook <- read.csv(file.path(folder, paste0(study, "_codebook.csv")), colClasses = "character")

wide <- function(form) {
  rows <- read.csv(file.path(folder, paste0(study, "_", form, ".csv")), colClasses = "character",
                   na.strings = c("", "NA"), check.names = FALSE)
  rows[rows$instance == "1", , drop = FALSE]
}
# Why a cell is empty stands in the long file alone.
long <- read.csv(file.path(folder, paste0(study, "_long.csv")), colClasses = "character",
                 na.strings = character(0), check.names = FALSE)
not_asked <- function(form, id)
  sum(long$questionnaire_id == form & long$item == id & long$instance == "1" &
        long$missing == "not asked")
numbers <- function(text) suppressWarnings(as.numeric(text))

wilson <- function(x, n) {
  z <- qnorm(0.975); p <- x / n
  centre <- (p + z^2 / (2 * n)) / (1 + z^2 / n)
  half <- z / (1 + z^2 / n) * sqrt(p * (1 - p) / n + z^2 / (4 * n^2))
  c(max(0, centre - half), min(1, centre + half))
}
student <- function(x) mean(x) + c(-1, 1) * qt(0.975, length(x) - 1) * sd(x) / sqrt(length(x))

# Two-sided, over all ways to choose the first group: as far from the middle, or farther.
exact_p <- function(x, y) {
  ranks <- rank(c(x, y)); n <- length(ranks); k <- length(x)
  middle <- k * (n + 1) / 2; seen <- sum(ranks[seq_len(k)])
  sums <- combn(n, k, function(chosen) sum(ranks[chosen]))
  mean(abs(sums - middle) >= abs(seen - middle) - 1e-9)
}
# What more than 60 people are compared by.
normal_p <- function(x, y) wilcox.test(x, y, exact = FALSE, correct = TRUE)$p.value
delta_of <- function(x, y) mean(outer(x, y, function(a, b) sign(a - b)))
# DeLong's variance of the area, delta = 2 area - 1.
delta_interval <- function(x, y) {
  psi <- outer(x, y, function(a, b) (a > b) + 0.5 * (a == b))
  se <- sqrt(var(rowMeans(psi)) / length(x) + var(colMeans(psi)) / length(y))
  area <- mean(psi)
  2 * pmin(1, pmax(0, area + c(-1, 1) * qnorm(0.975) * se)) - 1
}

found <- list()
add <- function(form, field, statistic, value)
  found[[paste(form, field, statistic, sep = "|")]] <<- value
add2 <- function(form, field, statistic, pair) {
  add(form, field, paste0(statistic, "_low"), pair[1])
  add(form, field, paste0(statistic, "_high"), pair[2])
}
describe <- function(form, id, x) {
  add(form, id, "n", length(x))
  if (length(x) == 0) return(invisible())
  add(form, id, "mean", mean(x))
  if (length(x) > 1) { add(form, id, "sd", sd(x)); add2(form, id, "mean_ci95", student(x)) }
}

forms <- setdiff(unique(codebook$form), c("participants", "attempts"))
for (form in forms) {
  rows <- wide(form)
  for (i in which(codebook$form == form)) {
    id <- codebook$item[i]; text <- rows[[id]]
    if (codebook$kind[i] == "ordinal") {
      x <- numbers(text); x <- x[!is.na(x)]
      describe(form, id, x)
      add(form, id, "missing", nrow(rows) - length(x) - not_asked(form, id))
      if (length(x) == 0) next
      q <- unname(quantile(x, c(0.25, 0.5, 0.75), type = 7))
      add(form, id, "q1", q[1]); add(form, id, "median", q[2]); add(form, id, "q3", q[3])
      codes <- numbers(trimws(sub("=.*", "", strsplit(codebook$values[i], "|", fixed = TRUE)[[1]])))
      top <- sum(x >= max(codes) - 1)
      add(form, id, "top2", top); add2(form, id, "top2_ci95", wilson(top, length(x)))
    } else if (codebook$kind[i] == "number") {
      x <- numbers(text); describe(form, id, x[!is.na(x)])
    } else if (codebook$kind[i] %in% c("nominal", "any of several")) {
      given <- strsplit(text[!is.na(text)], ";", fixed = TRUE)
      add(form, id, "n", length(given))
      for (code in trimws(sub("=.*", "", strsplit(codebook$values[i], "|", fixed = TRUE)[[1]])))
        add(form, id, paste0("count_", code), sum(vapply(given, function(g) code %in% g, TRUE)))
    }
  }
}

# Cronbach's alpha with Feldt's interval, of the scales whose rule stands in the codebook.
codes_of <- function(i)
  numbers(trimws(sub("=.*", "", strsplit(codebook$values[i], "|", fixed = TRUE)[[1]])))
for (row in which(expected$statistic == "alpha")) {
  form <- expected$form[row]; id <- expected$field[row]; rows <- wide(form)
  rule <- codebook$values[codebook$form == form & codebook$item == id]
  items <- strsplit(sub(" [+] .*$", "", sub("^.*(mean|sum) of ", "", rule)), " ")[[1]]
  x <- vapply(items, function(name) numbers(rows[[name]]), numeric(nrow(rows)))
  for (name in items) {
    i <- which(codebook$form == form & codebook$item == name)
    if (codebook$reverse_keyed[i] != "yes") next
    ends <- if (codebook$kind[i] == "ordinal") range(codes_of(i)) else
      numbers(c(codebook$minimum[i], codebook$maximum[i]))
    x[, name] <- sum(ends) - x[, name]
  }
  x <- x[stats::complete.cases(x), , drop = FALSE]; n <- nrow(x); k <- ncol(x)
  alpha <- k / (k - 1) * (1 - sum(apply(x, 2, var)) / var(rowSums(x)))
  add(form, id, "alpha", alpha)
  add2(form, id, "alpha_ci95",
       1 - (1 - alpha) * qf(c(0.975, 0.025), n - 1, (n - 1) * (k - 1)))
}

# The comparison of the first yes-or-no question with at least three people on each side.
if (any(expected$statistic == "delta")) {
  form <- expected$form[expected$statistic == "delta"][1]
  fields <- expected$field[expected$statistic == "delta"]
  groups <- NULL
  for (i in which(codebook$kind == "nominal" & codebook$form != "attempts")) {
    by <- codebook$form[i]
    if (by == "participants" && codebook$item[i] != "arm") next
    codes <- trimws(sub("=.*", "", strsplit(codebook$values[i], "|", fixed = TRUE)[[1]]))
    if (length(codes) != 2 || by == form) next
    rows <- wide(by); value <- rows[[codebook$item[i]]]
    if (min(sum(value == codes[1], na.rm = TRUE), sum(value == codes[2], na.rm = TRUE)) < 3) next
    groups <- setNames(value, rows$participant); low <- codes[1]; high <- codes[2]; break
  }
  rows <- wide(form); group <- groups[rows$participant]; p <- c()
  for (id in fields) {
    x <- numbers(rows[[id]])
    first <- x[!is.na(x) & !is.na(group) & group == high]
    second <- x[!is.na(x) & !is.na(group) & group == low]
    add(form, id, "delta", delta_of(first, second))
    add2(form, id, "delta_ci95", delta_interval(first, second))
    exact <- length(first) + length(second) <= 60
    p[id] <- if (exact) exact_p(first, second) else normal_p(first, second)
    add(form, id, if (exact) "p_exact" else "p_normal", p[[id]])
  }
  for (id in fields) add(form, id, "p_holm", p.adjust(p, "holm")[[id]])
}

bad <- 0; compared <- 0
for (row in seq_len(nrow(expected))) {
  key <- with(expected[row, ], paste(form, field, statistic, sep = "|"))
  value <- found[[key]]
  if (is.null(value) || !is.finite(value) ||
      abs(value - expected$value[row]) > 1e-6 * max(1, abs(value))) {
    cat(key, ": Placode", expected$value[row], ", R", format(value, digits = 12), "\n"); bad <- bad + 1
  }
  compared <- compared + 1
}
if (length(arguments) == 4) {
  keys <- do.call(rbind, strsplit(names(found), "|", fixed = TRUE))
  values <- vapply(found, function(v) format(v, digits = 15), "")
  own <- data.frame(form = keys[, 1], field = keys[, 2], statistic = keys[, 3], value = values)
  write.csv(own[names(found) %in% with(expected, paste(form, field, statistic, sep = "|")), ],
            arguments[4], row.names = FALSE, quote = FALSE)
}
if (compared == 0) { cat("nothing to compare\n"); quit(status = 1) }
cat(compared - bad, "of", compared, "numbers agree (R", as.character(getRversion()), ")\n")
quit(status = if (bad == 0) 0 else 1)
