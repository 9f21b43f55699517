//! What the tests of every chapter share: exact and dual numbers, the arbitrary-precision oracle, generators that aim at
//! trouble, and laws that explain how they were broken.
#![allow(dead_code, reason = "each chapter uses its part of this toolbox")]

pub mod bound;
pub mod dice;
pub mod dual;
pub mod exact;
pub mod generators;
pub mod law;
pub mod motion;
pub mod oracle;
