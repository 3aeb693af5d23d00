// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads pages of a running portal in Chromium, wide and narrow, light and dark, with axe (rules of
// WCAG 2.2 A and AA and its best practices), and goes through the review of an attempt. Each page
// is kept as a picture. Ends with 1 where something was found.
//   node check.mjs ADDRESS LOGIN PASSWORD PICTURES ATTEMPT
import fs from "node:fs";
import {createRequire} from "node:module";
import puppeteer from "puppeteer-core";

const [address, login, password, pictures, attempt] = process.argv.slice(2);
const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const rules = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];
const pages = ["/", "/cohort", "/help", "/refreshers", "/scores", "/attempts", "/standards", "/norms",
               "/people", `/attempts/${attempt}`];
let found = 0, checked = 0;

const browser = await puppeteer.launch({
  executablePath: process.env.CHROMIUM || "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});

const complain = (what) => {
  console.log(what);
  ++found;
};

async function look(page, name) {
  await page.screenshot({path: `${pictures}/${name}.png`, fullPage: true});
  await page.evaluate(axe);
  const {violations, passes} = await page.evaluate(
      (only) => globalThis.axe.run(document, {runOnly: only}), rules);
  if (passes.length < 5) complain(`${name}: axe looked at nothing`);
  for (const each of violations)
    complain(`${name}: ${each.impact}: ${each.help}: ${each.nodes[0].html.slice(0, 160)}`);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  if (wide > 0) complain(`${name}: ${wide} px wider than the window`);
  ++checked;
}

// The page asks again by itself until the track is there.
async function openReview(page) {
  await page.goto(`${address}/attempts/${attempt}/review`);
  for (let i = 0; i < 240 && !(await page.$("#review-picture").catch(() => null)); ++i)
    await new Promise((done) => setTimeout(done, 500));
  await page.waitForFunction(
      () => document.getElementById("review-clock")?.textContent.includes(" / "), {timeout: 60000});
}

/// Mean and spread of the canvas: something is drawn, and it is not one colour.
const seen = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => {
  const from = document.getElementById("review-picture"), to = document.createElement("canvas");
  to.width = to.height = 64;
  const paint = to.getContext("2d");
  paint.drawImage(from, 0, 0, 64, 64);
  const data = paint.getImageData(0, 0, 64, 64).data, reds = data.filter((_, i) => i % 4 === 0);
  done({least: Math.min(...reds), most: Math.max(...reds)});
})));

async function review(page, name) {
  await openReview(page);
  await look(page, name);
  const until = parseFloat(await page.$eval("#review-time", (slider) => slider.max));
  for (const camera of ["scope", "above", "side"]) {
    await page.select("#review-camera", camera);
    const begun = Date.now();
    await page.$eval("#review-time", (slider, at) => {
      slider.value = at;
      slider.dispatchEvent(new Event("input"));
    }, 0.7 * until);
    await page.waitForFunction((at) => {
      const [minutes, seconds] = document.getElementById("review-clock").textContent.split(":");
      return Math.abs(60 * minutes + parseInt(seconds, 10) - at) <= 1;
    }, {timeout: 30000}, 0.7 * until);
    console.log(`${name}: ${camera}, gone to 70 % in ${Date.now() - begun} ms`);
    await page.screenshot({path: `${pictures}/${name}-${camera}.png`});
  }
  await page.focus("#review-picture");
  await page.keyboard.press("ArrowLeft");
  const view = await page.$eval("#review-camera", (choice) => choice.value);
  if (view !== "free") complain(`${name}: an arrow key did not turn the picture`);
  await page.click("#review-play");
  const before = await page.$eval("#review-time", (slider) => parseFloat(slider.value));
  await new Promise((done) => setTimeout(done, 1500));
  const after = await page.$eval("#review-time", (slider) => parseFloat(slider.value));
  if (!(after > before)) complain(`${name}: Play did not play`);
}

for (const scheme of ["light", "dark"]) {
  for (const width of [1280, 390]) {
    const context = await browser.createBrowserContext(), page = await context.newPage();
    page.on("pageerror", (error) => complain(`script: ${error.message}`));
    page.on("console", (line) => line.type() === "error" && complain(`console: ${line.text()}`));
    await page.setBypassCSP(true);  // axe is not from this host
    await page.emulateMediaFeatures([{name: "prefers-color-scheme", value: scheme}]);
    await page.setViewport({width, height: 900});
    const name = (path) => `${scheme}-${width}${path.replaceAll("/", "-")}`;
    await page.goto(address + "/sign-in");
    await look(page, name("/sign-in"));
    await page.type("[name=login]", login);
    await page.type("[name=password]", password);
    await Promise.all([page.waitForNavigation(), page.click("button.primary")]);
    for (const path of pages) {
      await page.goto(address + path);
      await look(page, name(path));
    }
    await review(page, name("/review"));
    await context.close();
  }
}

// Once with the policy of content as people have it: the scripts must run under it.
const strict = await (await browser.createBrowserContext()).newPage();
strict.on("console", (line) => line.type() === "error" && complain(`policy: ${line.text()}`));
await strict.goto(address + "/sign-in");
await strict.type("[name=login]", login);
await strict.type("[name=password]", password);
await Promise.all([strict.waitForNavigation(), strict.click("button.primary")]);
await openReview(strict);
await browser.close();
console.log(`${checked} pages, ${found} found`);
process.exit(found > 0 ? 1 : 0);
