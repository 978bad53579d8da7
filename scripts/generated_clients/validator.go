// Package validator stands for gopkg.in/validator.v2, with which openapi-generator checks tags of struct members. Its
// clients have none. Debian's version of the package is older than the generator requires and refuses strings.
package validator

// Validate finds no fault, because the clients have no tags.
func Validate(interface{}) error { return nil }
